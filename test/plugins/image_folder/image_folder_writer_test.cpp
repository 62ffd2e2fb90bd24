#include <cmath>
#include <filesystem>
#include <limits>

#include <opencv2/imgcodecs.hpp>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "plugins/plugin_harness.h"
#include "plugins/written_files.h"

namespace synthetic_dataset {
namespace image_folder_writer_test {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class ImageFolder : public PluginTest {
 protected:
  ImageFolder() : PluginTest("synthetic_dataset/ImageFolder") {
    dataset_.classes = {{0, "cup"}, {2, "fork | \"lift\""}};
    dataset_.scene_count = 1;
  }

  [[nodiscard]] std::string fileAt(const std::string& path) const {
    return test::contentOf(folder() + path);
  }

  /// The only line of a dataset with this scene.
  [[nodiscard]] json lineOf(const Scene& scene) const {
    runAll({scene});
    return json::parse(fileAt("train/metadata.jsonl"));
  }

  [[nodiscard]] std::vector<std::string> pathsOf(const Scene& scene) const {
    std::vector<std::string> paths;
    for (const auto& [path, content] : filesOf(scene)) paths.push_back(path);
    return paths;
  }
};

TEST_F(ImageFolder, PutsImageAndMaskIntoTheSplitsFolder) {
  dataset_.splits = {{"val", 1}};
  load({});
  Scene split = scene(3, {});
  split.split = "val";
  split.name = "front/00000003";
  EXPECT_THAT(pathsOf(split), ElementsAre("val/front/00000003.mask.png", "val/front/00000003.png"));
}

TEST_F(ImageFolder, DescribesImageAndCamera) {
  load({});
  Scene moved = scene(3, {});
  moved.X_GC.translation() = Eigen::Vector3d(1.0, 2.0, 3.0);
  const json line = lineOf(moved);
  EXPECT_EQ(line["file_name"], "00000003.png");
  EXPECT_EQ(line["mask_file_name"], "00000003.mask.png");
  EXPECT_EQ(line["width"], 640);
  EXPECT_EQ(line["height"], 480);
  EXPECT_EQ(line["instant"], 3);
  EXPECT_EQ(line["stamp_ns"], 3);
  EXPECT_EQ(line["camera"]["name"], "camera");
  EXPECT_EQ(line["camera"]["K"], json({500.0, 0.0, 320.0, 0.0, 500.0, 240.0, 0.0, 0.0, 1.0}));
  EXPECT_EQ(line["camera"]["distortion_model"], "none");
  EXPECT_EQ(line["camera"]["X_GC"],
            json({1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 2.0, 0.0, 0.0, 1.0, 3.0, 0.0, 0.0, 0.0, 1.0}));
}

TEST_F(ImageFolder, TellsTheIntrinsicsThatAnImageHas) {
  dataset_.cameras[0].intrinsics_vary = true;
  load({});
  EXPECT_EQ(lineOf(zoomed(scene(3, {}), 700.0))["camera"]["K"],
            json({700.0, 0.0, 320.0, 0.0, 700.0, 240.0, 0.0, 0.0, 1.0}));
}

TEST_F(ImageFolder, DescribesObjects) {
  dataset_.objects.resize(1);
  dataset_.objects[0].keypoint_count = 3;
  load({});
  SceneObject object = seen("a", {-10, 20, 40, 30});
  object.class_id = 2;
  object.keypoints = {keypoint(Eigen::Vector2d(12.5, 30.0), 1.0, KeypointState::kVisible),
                      keypoint(Eigen::Vector2d(-12.5, 30.0), 1.0, KeypointState::kOutside),
                      keypoint(std::nullopt, -1.0, KeypointState::kOutside)};
  const json objects = lineOf(scene(0, {object}))["objects"];
  EXPECT_EQ(objects["bbox"], json({{0.0, 20.0, 30.0, 30.0}}));
  EXPECT_EQ(objects["categories"], json({2}));
  EXPECT_EQ(objects["class_names"], json({"a_class"}));
  EXPECT_EQ(objects["names"], json({"a"}));
  EXPECT_EQ(objects["ids"], json({"a_id"}));
  EXPECT_EQ(objects["instances"], json({1}));
  EXPECT_EQ(objects["visibility"], json({0.75}));
  EXPECT_EQ(objects["truncation"], json({0.25}));
  EXPECT_EQ(objects["distance"], json({10.0}));
  EXPECT_EQ(objects["X_CO"][0], json({1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 10.0,
                                      0.0, 0.0, 0.0, 1.0}));
  EXPECT_EQ(objects["cuboid"], json({{-0.5, -0.5, -0.5, 0.5, 0.5, 0.5}}));
  EXPECT_EQ(objects["keypoints"][0], json({{12.5, 30.0}, {-12.5, 30.0}, {0.0, 0.0}}));
  EXPECT_EQ(objects["keypoint_visibility"], json::parse("[[2, 0, 0]]"));
}

TEST_F(ImageFolder, HasTheSameKeysWithoutAnyObject) {
  load({});
  const json empty = lineOf(scene(0, {}));
  for (const auto& [key, list] : empty["objects"].items()) EXPECT_EQ(list, json::array()) << key;
  EXPECT_EQ(empty["objects"].size(), 13U);
}

TEST_F(ImageFolder, LeavesOutWhatIsHiddenOrDropped) {
  load({});
  SceneObject hidden = seen("a", {700, 20, 40, 30});
  SceneObject dropped = seen("b", {10, 20, 40, 30});
  dropped.dropped = true;
  EXPECT_THAT(lineOf(scene(0, {hidden, dropped}))["objects"]["names"], IsEmpty());
}

TEST_F(ImageFolder, WritesALineAnImage) {
  dataset_.splits = {{"train", 2}, {"test", 1}};
  load({{"masks", false}});
  std::vector<Scene> scenes = {scene(0, {}), scene(1, {}), scene(2, {})};
  scenes[0].split = scenes[2].split = "train";
  scenes[1].split = "test";
  runAll(scenes);
  const std::string train = fileAt("train/metadata.jsonl");
  EXPECT_THAT(train, StartsWith(R"({"file_name":"00000000.png","width":640,)"));
  EXPECT_THAT(train, HasSubstr("}\n{\"file_name\":\"00000002.png\""));
  EXPECT_THAT(fileAt("test/metadata.jsonl"), StartsWith(R"({"file_name":"00000001.png")"));
}

TEST_F(ImageFolder, WritesInstancesOfSixteenBits) {
  load({});
  runAll({scene(0, {seen("a", {0, 0, 9, 9}), seen("b", {50, 60, 9, 9})})});
  const cv::Mat mask = cv::imread(folder() + "train/00000000.mask.png", cv::IMREAD_UNCHANGED);
  ASSERT_EQ(mask.type(), CV_16UC1);
  EXPECT_EQ(mask.at<std::uint16_t>(60, 50), 2);
  EXPECT_EQ(mask.at<std::uint16_t>(59, 50), 0);
}

TEST_F(ImageFolder, WritesDepthInMetres) {
  load({{"depth", true}});
  EXPECT_EQ(lineOf(scene(0, {seen("a", {0, 0, 9, 9})}))["depth_file_name"], "00000000.depth.tiff");
  const cv::Mat depth = cv::imread(folder() + "train/00000000.depth.tiff", cv::IMREAD_UNCHANGED);
  ASSERT_EQ(depth.type(), CV_32FC1);
  EXPECT_EQ(depth.at<float>(0, 0), 10.0F);
}

TEST_F(ImageFolder, WritesNormalsAsColours) {
  load({{"normals", true}});
  Scene tilted = scene(0, {});
  cv::Mat given(480, 640, CV_32FC3, cv::Scalar(0.0, 0.0, 0.0));
  given.at<cv::Vec3f>(10, 20) = {1.0F, 0.6F, -1.0F};
  tilted.normals = given;
  runAll({tilted});
  const cv::Mat normals = cv::imread(folder() + "train/00000000.normals.png");
  // 0.6 is at 0.8 * 255 = 204. OpenCV's order: blue, green, red.
  EXPECT_EQ(normals.at<cv::Vec3b>(10, 20), cv::Vec3b(0, 204, 255));
  EXPECT_EQ(normals.at<cv::Vec3b>(10, 21), cv::Vec3b(0, 0, 0));
}

TEST_F(ImageFolder, KeepsFlowThatIsNotKnown) {
  load({{"optical_flow", true}});
  Scene moving = scene(0, {});
  cv::Mat flow(480, 640, CV_32FC2, cv::Scalar(1.5, -2.25));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  flow.at<cv::Vec2f>(10, 20) = {nan, nan};
  moving.optical_flow = flow;
  runAll({moving});
  const cv::Mat u = cv::imread(folder() + "train/00000000.flow_u.tiff", cv::IMREAD_UNCHANGED);
  const cv::Mat v = cv::imread(folder() + "train/00000000.flow_v.tiff", cv::IMREAD_UNCHANGED);
  EXPECT_EQ(u.at<float>(0, 0), 1.5F);
  EXPECT_EQ(v.at<float>(0, 0), -2.25F);
  EXPECT_TRUE(std::isnan(u.at<float>(10, 20)));
  EXPECT_TRUE(std::isnan(v.at<float>(10, 20)));
}

TEST_F(ImageFolder, PutsTheLineBesideTheImageForWebDataset) {
  load({{"webdataset", true}, {"masks", false}});
  const auto files = filesOf(scene(0, {}));
  const json line = lineOf(scene(0, {}));
  json beside = json::parse(files.at("train/00000000.json"));
  beside["file_name"] = "00000000.png";
  EXPECT_EQ(beside, line);
}

TEST_F(ImageFolder, TellsTheLoaderOfSplitsThatHaveImages) {
  dataset_.splits = {{"train", 2}, {"val", 1}, {"test", 0}};
  load({{"image_format", "jpg"}});
  runAll({});
  EXPECT_FALSE(std::filesystem::exists(folder() + "test"));
  EXPECT_THAT(fileAt("README.md"),
              AllOf(StartsWith("---\n"
                               "configs:\n"
                               "- config_name: default\n"),
                    HasSubstr("  data_files:\n"
                              "  - split: train\n"
                              "    path:\n"
                              "    - train/metadata.jsonl\n"
                              "    - train/**/*.png\n"
                              "    - train/**/*.jpg\n"
                              "  - split: validation\n"
                              "    path:\n"
                              "    - val/metadata.jsonl\n"),
                    Not(HasSubstr("split: test")), HasSubstr("- 2: `\"fork | \\\"lift\\\"\"`\n")));
}

TEST_F(ImageFolder, NamesAuthorsAndLicencesInTheCard) {
  dataset_.credits = {{"Ada", "MIT", {"m/model.sdf", "m/skin.png"}}, {"Bob", "", {"w/w.world"}}};
  load({});
  runAll({});
  EXPECT_THAT(fileAt("README.md"),
              AllOf(HasSubstr("- licence `\"MIT\"`, author `\"Ada\"`: `\"m/model.sdf\"`, "
                              "`\"m/skin.png\"`\n"),
                    HasSubstr("- licence not said, author `\"Bob\"`: `\"w/w.world\"`\n")));
  dataset_.credits.clear();
  load({});
  runAll({});
  EXPECT_THAT(fileAt("README.md"), Not(HasSubstr("licence")));
}

TEST_F(ImageFolder, GivesAnotherContentAnotherCard) {
  load({});
  const auto cardOf = [&](int grey, const std::string& object) {
    Scene only = scene(0, {seen(object, {10, 20, 30, 40})});
    only.image.at<cv::Vec3b>(479, 639)[2] = static_cast<uchar>(grey);
    runAll({only});
    const std::string card = fileAt("README.md");
    std::filesystem::remove_all(folder_.path());
    std::filesystem::create_directories(folder_.path());
    return card;
  };
  const std::string card = cardOf(1, "a");
  EXPECT_EQ(cardOf(1, "a"), card);
  EXPECT_NE(cardOf(2, "a"), card);
  EXPECT_NE(cardOf(1, "b"), card);
}

TEST_F(ImageFolder, AsksForWhatItWrites) {
  const Requirements plain = load({}).requirements();
  EXPECT_FALSE(plain.depth || plain.normals || plain.optical_flow || plain.keypoint_states);
  EXPECT_TRUE(plain.visible_masks && plain.visibility);
  const Requirements all =
      load({{"depth", true}, {"normals", true}, {"optical_flow", true}}).requirements();
  EXPECT_TRUE(all.depth && all.normals && all.optical_flow);
}

}  // namespace image_folder_writer_test
}  // namespace synthetic_dataset
