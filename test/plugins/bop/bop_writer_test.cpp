#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include "plugins/bop/bop_fixture.h"
#include "plugins/shared/json.h"

namespace synthetic_dataset {
namespace bop_writer_test {

using nlohmann::json;
using testing::Contains;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pointwise;

TEST_F(Bop, MakesASceneFolderThatTheToolkitKnows) {
  load({});
  runAll({scene(3, roverAndLift())});
  for (const char* file :
       {"rgb/000003.png", "depth/000003.png", "mask/000003_000000.png", "mask/000003_000001.png",
        "mask_visib/000003_000000.png", "mask_visib/000003_000001.png", "scene_camera.json",
        "scene_gt.json", "scene_gt_info.json", "scene_gt_coco.json"}) {
    EXPECT_TRUE(exists(std::string("train/000000/") + file)) << file;
  }
  for (const char* file :
       {"camera.json", "dataset_info.json", "models/obj_000001.ply", "models/obj_000002.ply",
        "models/models_info.json", "models_eval/obj_000001.ply", "models_eval/models_info.json"}) {
    EXPECT_TRUE(exists(file)) << file;
  }
  EXPECT_FALSE(exists("test_targets_bop19.json"));
}

TEST_F(Bop, WritesPosesOfTheBoxesCentresInMillimetres) {
  load({});
  SceneObject rover = seen("rover", {100, 80, 50, 40});
  // Its z points up (the camera's -y), its x to the right; the model's centre is 0.3 m up.
  rover.X_CO->linear() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  rover.X_CO->translation() = Eigen::Vector3d(0.5, 1.0, 4.0);
  runAll({scene(0, {rover})});
  const json pose = jsonOf("train/000000/scene_gt.json").at("0").at(0);
  EXPECT_EQ(pose.at("obj_id"), 1);
  EXPECT_EQ(pose.at("cam_R_m2c"), json({1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0}));
  EXPECT_THAT(pose.at("cam_t_m2c").get<std::vector<double>>(),
              Pointwise(DoubleNear(1e-9), {500.0, 700.0, 4000.0}));
}

TEST_F(Bop, KeepsTheObjectsOwnFrameWhenAsked) {
  load({{"centre_models", false}});
  SceneObject rover = seen("rover", {100, 80, 50, 40});
  rover.X_CO->translation() = Eigen::Vector3d(0.5, 1.0, 4.0);
  runAll({scene(0, {rover})});
  EXPECT_EQ(jsonOf("train/000000/scene_gt.json").at("0").at(0).at("cam_t_m2c"),
            json({500.0, 1000.0, 4000.0}));
  EXPECT_EQ(jsonOf("models/models_info.json").at("1").at("min_z"), 0.0);
  EXPECT_EQ(jsonOf("dataset_info.json").at("objects").at(0).at("model_origin"),
            json({0.0, 0.0, 0.0}));
}

TEST_F(Bop, ReprojectsModelsToTheScenesOwnPixels) {
  load({});
  SceneObject rover = seen("rover", {100, 80, 50, 40});
  rover.X_CO->linear() =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).matrix();
  rover.X_CO->translation() = Eigen::Vector3d(-0.4, 0.2, 6.0);
  runAll({scene(0, {rover})});

  const json camera_json = jsonOf("train/000000/scene_camera.json").at("0");
  const json pose_json = jsonOf("train/000000/scene_gt.json").at("0").at(0);
  const auto k = camera_json.at("cam_K").get<std::vector<double>>();
  const auto r = pose_json.at("cam_R_m2c").get<std::vector<double>>();
  const auto t = pose_json.at("cam_t_m2c").get<std::vector<double>>();
  std::ifstream ply(folder() + "models/obj_000001.ply");
  for (std::string line; std::getline(ply, line) && line != "end_header";) {
  }
  for (const Eigen::Vector3d& corner_O : Cuboid{{-1.0, -0.5, 0.0}, {1.0, 0.5, 0.6}}.corners()) {
    double m[9];  // position, normal, colour
    for (double& number : m) ply >> number;
    double p[3];
    for (int i = 0; i < 3; ++i) {
      p[i] = r[3 * i] * m[0] + r[3 * i + 1] * m[1] + r[3 * i + 2] * m[2] + t[i];
    }
    const auto expected = scene(0, {}).camera.project(*rover.X_CO * corner_O);
    EXPECT_NEAR(k[0] * p[0] / p[2] + k[2], expected->x(), 1e-4);
    EXPECT_NEAR(k[4] * p[1] / p[2] + k[5], expected->y(), 1e-4);
  }
}

TEST_F(Bop, WritesEachImagesIntrinsics) {
  dataset_.cameras[0].intrinsics_vary = true;
  load({});
  runAll({scene(0, {}), zoomed(scene(1, {}), 700.0)});
  const json cameras = jsonOf("train/000000/scene_camera.json");
  EXPECT_EQ(cameras.at("0").at("cam_K").at(0), 500.0);
  EXPECT_EQ(cameras.at("1").at("cam_K").at(0), 700.0);
  EXPECT_EQ(jsonOf("camera.json").at("fx"), 500.0) << "of the calibration";
  EXPECT_EQ(jsonOf("dataset_info.json").at("cameras").at(0).at("intrinsics_vary"), true);
}

TEST_F(Bop, CountsPixelsAndMeasuresBoxesAsTheToolkitDoes) {
  load({});
  runAll({scene(0, roverAndLift())});
  const json info = jsonOf("train/000000/scene_gt_info.json").at("0").at(0);
  EXPECT_EQ(info.at("bbox_obj"), json({100, 80, 49, 39}));
  EXPECT_EQ(info.at("bbox_visib"), json({120, 80, 29, 39}));
  EXPECT_EQ(info.at("px_count_all"), 2000);
  EXPECT_EQ(info.at("px_count_valid"), 2000);
  EXPECT_EQ(info.at("px_count_visib"), 1200);
  EXPECT_EQ(info.at("visib_fract"), 0.6);
}

TEST_F(Bop, LetsTheSilhouettesBoxLeaveTheImage) {
  load({});
  const auto boxOf = [&](const cv::Rect& pixels) {
    const Scene cut = scene(0, {seen("rover", pixels)});
    const auto record = host_->writeScene(cut).files.records.at(0).text;
    return json::parse(record).at(6).at(0).at("bbox_obj");
  };
  EXPECT_EQ(boxOf({-30, 100, 50, 40}), json({-30, 100, 49, 39}));
  EXPECT_EQ(boxOf({620, 100, 50, 40}), json({620, 100, 49, 39}));
  EXPECT_EQ(boxOf({100, -20, 50, 40}), json({100, -20, 49, 39}));
  EXPECT_EQ(boxOf({100, 470, 50, 40}), json({100, 470, 49, 39}));
}

TEST_F(Bop, CountsAsValidOnlyWhereTheDepthImageHasDepth) {
  load({});
  Scene holed = scene(0, {seen("rover", {100, 80, 50, 40})});
  cv::Mat(holed.depth(), cv::Rect(100, 80, 10, 40)).setTo(0.0F);
  runAll({holed});
  EXPECT_EQ(jsonOf("train/000000/scene_gt_info.json").at("0").at(0).at("px_count_valid"), 1600);
}

TEST_F(Bop, ListsHiddenObjectsWithoutBoxes) {
  load({});
  runAll({scene(0, {hidden(seen("rover", {100, 80, 50, 40}))})});
  const json info = jsonOf("train/000000/scene_gt_info.json").at("0").at(0);
  EXPECT_EQ(info.at("bbox_obj"), json({-1, -1, -1, -1}));
  EXPECT_EQ(info.at("bbox_visib"), json({-1, -1, -1, -1}));
  EXPECT_EQ(info.at("px_count_all"), 2000);
  EXPECT_TRUE(exists("train/000000/mask/000000_000000.png"));
  EXPECT_THAT(jsonOf("train/000000/scene_gt_coco.json").at("annotations"), IsEmpty());
}

TEST_F(Bop, WritesObjectsThatSubtractionHasNotFound) {
  load({});
  SceneObject lost = seen("rover", {100, 80, 50, 40});
  lost.silhouette = lost.visible_mask = Mask(lost.silhouette().imageSize());
  runAll({scene(0, {lost})});
  const json info = jsonOf("train/000000/scene_gt_info.json").at("0").at(0);
  EXPECT_EQ(info.at("px_count_valid"), 0);
  EXPECT_EQ(info.at("bbox_visib"), json({-1, -1, -1, -1}));
  EXPECT_TRUE(exists("train/000000/mask/000000_000000.png"));
  EXPECT_THAT(jsonOf("train/000000/scene_gt_coco.json").at("annotations"), IsEmpty());
}

TEST_F(Bop, LeavesOutObjectsOutsideTheImage) {
  load({});
  SceneObject outside = seen("rover", {700, 80, 50, 40});
  runAll({scene(0, {outside, seen("lift", {60, 80, 60, 40})})});
  const json poses = jsonOf("train/000000/scene_gt.json").at("0");
  ASSERT_EQ(poses.size(), 1U);
  EXPECT_EQ(poses.at(0).at("obj_id"), 2);
  EXPECT_TRUE(exists("train/000000/mask/000000_000000.png"));
  EXPECT_FALSE(exists("train/000000/mask/000000_000001.png"));
}

TEST_F(Bop, KeepsScenesWithoutObjects) {
  load({});
  runAll({scene(0, {})});
  EXPECT_EQ(jsonOf("train/000000/scene_gt.json").at("0"), json::array());
  EXPECT_EQ(jsonOf("train/000000/scene_gt_info.json").at("0"), json::array());
  EXPECT_TRUE(jsonOf("train/000000/scene_camera.json").contains("0"));
}

TEST_F(Bop, FinishesADatasetWithoutScenes) {
  load({});
  runAll({});
  EXPECT_FALSE(exists("train"));
  EXPECT_TRUE(exists("models/obj_000001.ply"));
}

TEST_F(Bop, SavesDepthInMultiplesOfTheScale) {
  load({{"depth_scale", 0.5}});
  Scene deep = scene(0, {});
  cv::Mat given = deep.depth();
  given.at<float>(10, 20) = 1.2344F;   // 2468.8 half millimetres
  given.at<float>(11, 20) = 32.7675F;  // 65535
  given.at<float>(12, 20) = 32.7682F;  // 65536.4: too far
  given.at<float>(13, 20) = -2.0F;     // beside a fisheye's axis
  const auto result = host_->writeScene(deep);
  EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("farther than a depth image can hold")));
  runAll({deep});
  const cv::Mat depth =
      cv::imread(folder() + "train/000000/depth/000000.png", cv::IMREAD_UNCHANGED);
  ASSERT_EQ(depth.type(), CV_16UC1);
  EXPECT_EQ(depth.at<std::uint16_t>(10, 20), 2469);
  EXPECT_EQ(depth.at<std::uint16_t>(11, 20), 65535);
  EXPECT_EQ(depth.at<std::uint16_t>(12, 20), 0);
  EXPECT_EQ(depth.at<std::uint16_t>(13, 20), 0);
  EXPECT_EQ(jsonOf("train/000000/scene_camera.json").at("0").at("depth_scale"), 0.5);
  EXPECT_EQ(jsonOf("camera.json").at("depth_scale"), 0.5);
}

TEST_F(Bop, SavesTheDepthOfEveryColumn) {
  load({{"depth_scale", 1.0}});
  std::vector<Scene> scenes;
  for (const int width : {1, 7, 8, 13, 24}) {
    scenes.push_back(scene(static_cast<std::int64_t>(scenes.size()), {}));
    cv::Mat depth(3, width, CV_32FC1);
    cv::randu(depth, -1.0F, 80.0F);
    scenes.back().depth = depth;
  }
  runAll(scenes);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const cv::Mat depth = cv::imread(
        folder() + "train/000000/depth/00000" + std::to_string(i) + ".png", cv::IMREAD_UNCHANGED);
    ASSERT_EQ(depth.size(), scenes[i].depth().size());
    for (int pixel = 0; pixel < static_cast<int>(depth.total()); ++pixel) {
      const cv::Point place(pixel % depth.cols, pixel / depth.cols);
      const double millimetres = 1000.0 * double{scenes[i].depth().at<float>(place)};
      const bool is_held = millimetres > 0.0 && millimetres < 65535.5;
      EXPECT_EQ(depth.at<std::uint16_t>(place), is_held ? std::llround(millimetres) : 0);
    }
  }
}

TEST_F(Bop, ChoosesTenthsOfMillimetresWhereTheyReachTheFarPlane) {
  const auto scaleWithFar = [&](double far) {
    dataset_.cameras = {{"camera", "c", {640, 480, {500.0, 500.0, 320.0, 240.0}, 0.05, far}}};
    load({});
    const auto record = host_->writeScene(scene(0, {})).files.records.at(0).text;
    return json::parse(record).at(4).at("depth_scale").get<double>();
  };
  EXPECT_EQ(scaleWithFar(6.5), 0.1);
  EXPECT_EQ(scaleWithFar(6.6), 1.0);
  EXPECT_EQ(scaleWithFar(1000.0), 1.0);
}

TEST_F(Bop, TellsTheCamerasPlaceInTheWorld) {
  load({});
  Scene placed = scene(0, {});
  placed.X_GC.translation() = Eigen::Vector3d(1.0, 2.0, 3.0);
  placed.X_GC.linear() = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()).matrix();
  runAll({placed});
  const json camera_json = jsonOf("train/000000/scene_camera.json").at("0");
  // The world's x axis is the camera's -y; p_CG = -R_CG (1, 2, 3) = -(2, -1, 3).
  EXPECT_THAT(camera_json.at("cam_R_w2c").get<std::vector<double>>(),
              Pointwise(DoubleNear(1e-12), {0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0}));
  EXPECT_THAT(camera_json.at("cam_t_w2c").get<std::vector<double>>(),
              Pointwise(DoubleNear(1e-9), {-2000.0, 1000.0, -3000.0}));
  EXPECT_EQ(camera_json.at("cam_K"), json({500.0, 0.0, 320.0, 0.0, 500.0, 240.0, 0.0, 0.0, 1.0}));
}

TEST_F(Bop, RefusesWrongNumbers) {
  load({{"images_per_scene", 0},
        {"depth_scale", -1.0},
        {"image_format", "bmp"},
        {"obj_ids", Value::Map{{"rover", 0}}}});
  EXPECT_THAT(parameters_.errors(),
              ElementsAre("w/obj_ids/rover: found 0; it should be a whole number from 1",
                          "w/images_per_scene: found 0; it should be a whole number from 1",
                          "w/depth_scale: found -1.0; it should be greater than 0 [mm]",
                          HasSubstr("w/image_format: found 'bmp'")));
}

TEST_F(Bop, BeginsANewSceneFolderAfterSoManyImages) {
  load({{"images_per_scene", 2}});
  runAll({scene(0, {}), scene(1, roverAndLift()), scene(2, roverAndLift())});
  EXPECT_EQ(jsonOf("train/000000/scene_gt.json").size(), 2U);
  EXPECT_EQ(jsonOf("train/000001/scene_gt.json").size(), 1U);
  EXPECT_TRUE(exists("train/000001/rgb/000000.png"));
  // Annotations are numbered from 1 in each folder.
  EXPECT_EQ(jsonOf("train/000001/scene_gt_coco.json").at("annotations").at(0).at("id"), 1);
}

TEST_F(Bop, KeepsImagesInTheirOrder) {
  load({});
  std::vector<Scene> scenes;
  for (int i = 0; i < 12; ++i) scenes.push_back(scene(i, {}));
  runAll(scenes);
  std::ifstream stream(folder() + "train/000000/scene_gt.json");
  const auto inOrder = Json::parse(stream);
  int expected = 0;
  for (const auto& entry : inOrder.items()) EXPECT_EQ(entry.key(), std::to_string(expected++));
}

TEST_F(Bop, NumbersScenesOfSeveralCamerasApart) {
  dataset_.cameras = {{"front", "f", camera()}, {"rear", "r", camera()}};
  load({{"images_per_scene", 1}});
  std::vector<Scene> scenes;
  for (int i = 0; i < 4; ++i) {
    scenes.push_back(scene(i, {}));
    scenes.back().instant = i / 2;
    scenes.back().camera_index = static_cast<std::size_t>(i % 2);
  }
  runAll(scenes);
  for (const char* number : {"000000", "000001", "000002", "000003"}) {
    EXPECT_TRUE(exists(std::string("train/") + number + "/rgb/000000.png")) << number;
    EXPECT_EQ(jsonOf(std::string("train/") + number + "/scene_camera.json").size(), 1U);
  }
  EXPECT_TRUE(exists("camera_rear.json"));
  EXPECT_EQ(jsonOf("dataset_info.json").at("cameras").at(1).at("name"), "rear");
}

TEST_F(Bop, ListsTargetsOfTheTestSplit) {
  dataset_.splits = {{"train", 1}, {"test", 1}};
  load({{"train_type", "pbr"}, {"obj_ids", Value::Map{{"rover", 5}, {"lift", 5}}}});
  Scene train = scene(0, roverAndLift());
  train.split = "train";
  Scene test = scene(1, roverAndLift());
  test.split = "test";
  runAll({train, test});
  EXPECT_TRUE(exists("train_pbr/000000/rgb/000000.jpg"));  // as bop_toolkit opens them
  EXPECT_TRUE(exists("test/000000/rgb/000001.png"));
  EXPECT_EQ(jsonOf("test_targets_bop19.json"),
            json::parse(R"([{"scene_id": 0, "im_id": 1, "obj_id": 5, "inst_count": 2}])"));
}

TEST_F(Bop, WritesPngInTrainPbrWhenAskedTo) {
  load({{"train_type", "pbr"}, {"image_format", "png"}});
  runAll({scene(0, roverAndLift())});
  EXPECT_TRUE(exists("train_pbr/000000/rgb/000000.png"));
}

TEST_F(Bop, SetsNoTargetBelowATenthOfVisibility) {
  dataset_.splits = {{"test", 1}};
  load({});
  std::vector<SceneObject> objects = roverAndLift();
  objects[0].pixels.visible = 180;  // of 2000
  Scene test = scene(0, objects);
  test.split = "test";
  runAll({test});
  const json targets = jsonOf("test_targets_bop19.json");
  ASSERT_EQ(targets.size(), 1U);
  EXPECT_EQ(targets.at(0).at("obj_id"), 2);
  const json annotations = jsonOf("test/000000/scene_gt_coco.json").at("annotations");
  EXPECT_EQ(annotations.at(0).at("ignore"), true);
  EXPECT_EQ(annotations.at(1).at("ignore"), false);
}

TEST_F(Bop, AnnotatesForCocoWithVisibleMasksInSilhouettesBoxes) {
  load({});
  SceneObject rover = seen("rover", {-1, 0, 3, 2});  // columns 0 and 1 of rows 0 and 1 in the image
  runAll({scene(0, {rover})});
  const json coco = jsonOf("train/000000/scene_gt_coco.json");
  const json& annotation = coco.at("annotations").at(0);
  EXPECT_EQ(annotation.at("bbox"), json({0, 0, 2, 2}));
  EXPECT_EQ(annotation.at("area"), 4);
  // A run of zeros comes first, here empty; then two rows of a column of 480, twice, and the rest.
  EXPECT_EQ(annotation.at("segmentation").at("counts"), json({0, 2, 478, 2, 638 * 480 + 478}));
  EXPECT_EQ(annotation.at("segmentation").at("size"), json({480, 640}));
  EXPECT_EQ(coco.at("images").at(0).at("file_name"), "rgb/000000.png");
  EXPECT_EQ(coco.at("categories").size(), 2U);
}

TEST_F(Bop, LeavesCocoOutWhenAsked) {
  load({{"coco", false}});
  runAll({scene(0, roverAndLift())});
  EXPECT_FALSE(exists("train/000000/scene_gt_coco.json"));
}

TEST_F(Bop, WarnsOfALensThatTheFormatCannotExpress) {
  const output::WriterHost& host = load({});
  Distortion fisheye;
  fisheye.model = DistortionModel::kEquidistant;
  Scene distorted = scene(0, {});
  distorted.camera = CameraModel(640, 480, {500.0, 500.0, 320.0, 240.0}, 0.05, 100.0, fisheye);
  EXPECT_THAT(host.writeScene(distorted).warnings, Contains(HasSubstr("no lens distortion")));
}

TEST_F(Bop, LabelsThreeHundredObjects) {
  dataset_.objects.clear();
  models_.clear();
  std::vector<SceneObject> objects;
  for (int i = 0; i < 300; ++i) {
    addObject("o" + std::to_string(i), {{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}});
    objects.push_back(seen("o" + std::to_string(i), {i, i, 10, 10}));
  }
  load({});
  const auto files = filesOf(scene(0, objects));
  EXPECT_EQ(files.at("train/000000/mask/000000_000299.png"), "<silhouette o299>");
  EXPECT_EQ(files.at("train/000000/mask_visib/000000_000299.png"), "<visible o299>");
  EXPECT_EQ(files.size(), 602U);
}

}  // namespace bop_writer_test
}  // namespace synthetic_dataset
