#include <cmath>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include "plugins/plugin_harness.h"

namespace synthetic_dataset {
namespace cityscapes_writer_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

class Cityscapes : public PluginTest {
 protected:
  Cityscapes() : PluginTest("synthetic_dataset/Cityscapes") {
    dataset_.classes = {{0, "robot"}, {5, "fork lift"}};
  }

  [[nodiscard]] static SceneObject of(int class_id, const cv::Rect& pixels) {
    SceneObject result = seen("a", pixels);
    result.class_id = class_id;
    return result;
  }

  [[nodiscard]] int labelAt(const Scene& scene, int x, int y) const {
    return pictureOf(scene, kBase + "labelIds.png").at<uchar>(y, x);
  }
  [[nodiscard]] int instanceAt(const Scene& scene, int x, int y) const {
    return pictureOf(scene, kBase + "instanceIds.png").at<ushort>(y, x);
  }
  [[nodiscard]] nlohmann::json jsonOf(const Scene& scene, const std::string& path) const {
    return nlohmann::json::parse(filesOf(scene).at(path));
  }

  const std::string kBase = "gtFine/train/camera/camera_000000_000019_gtFine_";
};

TEST_F(Cityscapes, NamesFilesAsItsToolsTakeThemApart) {
  dataset_.cameras[0].name = "front_left";
  load({});
  Scene third = scene(3, {});
  third.split = "val";
  std::vector<std::string> paths;
  for (const auto& [path, content] : filesOf(third)) paths.push_back(path);
  EXPECT_THAT(paths,
              ElementsAre("camera/val/front-left/front-left_000003_000019_camera.json",
                          "gtFine/val/front-left/front-left_000003_000019_gtFine_color.png",
                          "gtFine/val/front-left/front-left_000003_000019_gtFine_instanceIds.png",
                          "gtFine/val/front-left/front-left_000003_000019_gtFine_labelIds.png",
                          "gtFine/val/front-left/front-left_000003_000019_gtFine_labelTrainIds.png",
                          "gtFine/val/front-left/front-left_000003_000019_gtFine_polygons.json",
                          "imgsFine/leftImg8bit/val/front-left/"
                          "front-left_000003_000019_leftImg8bit.png",
                          "leftImg8bit/val/front-left/front-left_000003_000019_leftImg8bit.png"));
}

TEST_F(Cityscapes, KeepsCamerasApartWhoseNamesBecomeAlike) {
  dataset_.cameras = {{"a_b", "f", camera()}, {"a-b", "g", camera()}};
  load({});
  Scene second = scene(0, {});
  second.camera_index = 1;
  EXPECT_EQ(filesOf(second).count("camera/train/a-b-2/a-b-2_000000_000019_camera.json"), 1U);
}

TEST_F(Cityscapes, NumbersLabelsAndInstances) {
  load({});
  SceneObject dropped = of(0, {300, 0, 10, 10});
  dropped.dropped = true;
  const Scene all =
      scene(0, {of(5, {0, 0, 10, 10}), of(0, {20, 0, 10, 10}), dropped, of(5, {639, 479, 1, 1})});
  EXPECT_EQ(labelAt(all, 0, 0), 6);
  EXPECT_EQ(instanceAt(all, 0, 0), 6000);
  EXPECT_EQ(labelAt(all, 20, 0), 1);
  EXPECT_EQ(instanceAt(all, 20, 0), 1000);
  EXPECT_EQ(instanceAt(all, 639, 479), 6001);
  EXPECT_EQ(labelAt(all, 300, 0), 0);
  EXPECT_EQ(instanceAt(all, 300, 0), 0);
  EXPECT_EQ(instanceAt(all, 15, 0), 0);
}

TEST_F(Cityscapes, TakesLabelsOfTheUsersChoice) {
  load({{"label_ids", Value::Map{{"robot", 26}, {"fork lift", 26}}}, {"world_id", 7}});
  const Scene two = scene(0, {of(5, {0, 0, 10, 10}), of(0, {20, 0, 10, 10})});
  EXPECT_EQ(instanceAt(two, 0, 0), 26000);
  EXPECT_EQ(instanceAt(two, 20, 0), 26001);
  EXPECT_EQ(instanceAt(two, 15, 0), 7);
  EXPECT_EQ(labelAt(two, 15, 0), 7);
}

TEST_F(Cityscapes, HasCityscapesNamesAndTrainIdsWithItsOwnLabels) {
  load({{"label_ids", Value::Map{{"robot", 26}, {"fork lift", 33}}}});
  const Scene two = scene(0, {of(5, {0, 0, 10, 10}), of(0, {20, 0, 10, 10})});
  const auto polygons = jsonOf(two, kBase + "polygons.json")["objects"];
  EXPECT_EQ(polygons[0]["label"], "bicycle");  // json2labelImg.py knows no other names
  EXPECT_EQ(polygons[1]["label"], "car");
  const cv::Mat train_ids = pictureOf(two, kBase + "labelTrainIds.png");
  EXPECT_EQ(train_ids.at<uchar>(0, 0), 18);
  EXPECT_EQ(train_ids.at<uchar>(0, 20), 13);
  EXPECT_EQ(train_ids.at<uchar>(0, 15), 255);
  const cv::Mat colours = pictureOf(two, kBase + "color.png");
  EXPECT_EQ(colours.at<cv::Vec3b>(0, 20), cv::Vec3b(142, 0, 0));  // blue, green, red
  runAll({two});
  const auto table = nlohmann::json::parse(test::readFile(folder() + "labels.json"));
  EXPECT_EQ(table[26]["name"], "car");
  EXPECT_EQ(table[7]["trainId"], 0);
}

TEST_F(Cityscapes, NumbersTrainIdsOfItsOwnClassesFrom0) {
  load({});
  const Scene two = scene(0, {of(5, {0, 0, 10, 10}), of(0, {20, 0, 10, 10})});
  const cv::Mat train_ids = pictureOf(two, kBase + "labelTrainIds.png");
  EXPECT_EQ(train_ids.at<uchar>(0, 0), 1);
  EXPECT_EQ(train_ids.at<uchar>(0, 20), 0);
  EXPECT_EQ(train_ids.at<uchar>(0, 15), 255);
  runAll({two});
  // Robot and fork lift have the labels 1 and 6, of which these are the colours.
  EXPECT_EQ(test::readFile(folder() + "label_colors.txt"),
            "128 0 0 robot\n0 128 128 fork_lift\n0 0 0 background\n");
}

TEST_F(Cityscapes, LabelsClassesOfTheWorld) {
  dataset_.world_classes = {"floor", "wall"};
  EXPECT_TRUE(load({}).requirements().world_map);
  Scene two = scene(0, {of(5, {0, 0, 10, 10}), of(0, {20, 0, 10, 10})});
  cv::Mat world = cv::Mat::zeros(480, 640, CV_16UC1);
  world(cv::Rect(0, 0, 640, 80)) = 2;
  two.world_map = world;
  EXPECT_EQ(labelAt(two, 0, 0), 6);
  EXPECT_EQ(labelAt(two, 15, 0), 8);  // the greatest label is 6, the floor's is 7
  EXPECT_EQ(instanceAt(two, 15, 0), 8);
  EXPECT_EQ(labelAt(two, 15, 100), 0);
  const auto polygons = jsonOf(two, kBase + "polygons.json")["objects"];
  EXPECT_EQ(polygons[0]["label"], "wall");  // what is in front of it is drawn over it
  EXPECT_EQ(polygons.size(), 3U);
  runAll({two});
  const auto table = nlohmann::json::parse(test::readFile(folder() + "labels.json"));
  EXPECT_EQ(table[4]["name"], "wall");
  EXPECT_EQ(table[4]["hasInstances"], false);
  EXPECT_EQ(table[4]["trainId"], 3);
}

TEST_F(Cityscapes, WantsItsOwnLabelsForTheWorldTooWhereItsClassesHaveThem) {
  dataset_.world_classes = {"floor"};
  load({{"label_ids", Value::Map{{"robot", 26}, {"fork lift", 33}}}});
  EXPECT_THAT(parameters_.errors(), ElementsAre(HasSubstr("w/label_ids/floor: missing")));
  load({{"label_ids", Value::Map{{"robot", 26}, {"fork lift", 33}, {"floor", 7}}}});
  EXPECT_THAT(parameters_.errors(), IsEmpty());
}

TEST_F(Cityscapes, RefusesLabelsThatDoNotFitIntoThePictures) {
  dataset_.classes = {{63, "fits"}, {64, "does not"}};
  load({{"world_id", 65}});
  EXPECT_THAT(parameters_.errors(),
              ElementsAre(HasSubstr("w/world_id: found 65; it should be 0 to 64"),
                          HasSubstr("w/label_ids: found 65 for the class 'does not'; it should be "
                                    "1 to 64")));
}

TEST_F(Cityscapes, TellsOfMisspeltClasses) {
  load({{"label_ids", Value::Map{{"robt", 26}}}});
  EXPECT_THAT(parameters_.unknownNames(), ElementsAre("w/label_ids/robt"));
}

TEST_F(Cityscapes, WritesObjectsAfterThe1000thAsAGroup) {
  const output::WriterHost& host = load({});
  std::vector<SceneObject> many(1001, of(5, {0, 0, 1, 1}));
  many[999] = of(5, {10, 0, 1, 1});
  many[1000] = of(5, {20, 0, 1, 1});
  const Scene full = scene(0, many);
  EXPECT_EQ(instanceAt(full, 10, 0), 6999);
  EXPECT_EQ(instanceAt(full, 20, 0), 6);
  EXPECT_THAT(host.writeScene(full).warnings, ElementsAre(HasSubstr("more than 1000 objects")));
  EXPECT_EQ(jsonOf(full, kBase + "polygons.json")["objects"][1000]["label"], "fork liftgroup");
}

TEST_F(Cityscapes, WritesPolygonsThatAreTheMaskWhenFilled) {
  load({});
  SceneObject ring = of(0, {100, 100, 50, 50});
  ring.visible_mask = painted(ring.visible_mask(), {120, 120, 10, 10}, false);
  const auto json = jsonOf(scene(0, {ring}), kBase + "polygons.json");
  EXPECT_EQ(json["imgHeight"], 480);
  EXPECT_EQ(json["imgWidth"], 640);
  EXPECT_EQ(json["objects"][0]["label"], "robot");
  std::vector<cv::Point> points;
  for (const auto& point : json["objects"][0]["polygon"]) {
    points.emplace_back(point[0].get<int>(), point[1].get<int>());
  }
  cv::Mat filled(480, 640, CV_8UC1, cv::Scalar(0));
  cv::fillPoly(filled, std::vector<std::vector<cv::Point>>{points}, 255);
  EXPECT_EQ(cv::countNonZero(filled != ring.visible_mask().whole()), 0);
}

TEST_F(Cityscapes, WritesAnImageWithoutObjects) {
  load({});
  const Scene empty = scene(0, {});
  EXPECT_EQ(jsonOf(empty, kBase + "polygons.json")["objects"].size(), 0U);
  EXPECT_EQ(cv::countNonZero(pictureOf(empty, kBase + "instanceIds.png")), 0);
}

TEST_F(Cityscapes, WritesTheCamera) {
  load({});
  Scene posed = scene(0, {});
  // Looks along the global frame's y axis, 0.1 rad downwards: a body that is turned a quarter to
  // the left and pitched by 0.1 about its left axis.
  const double c = std::cos(0.1);
  const double s = std::sin(0.1);
  posed.X_GC.linear().col(0) = Eigen::Vector3d(1.0, 0.0, 0.0);  // right
  posed.X_GC.linear().col(1) = Eigen::Vector3d(0.0, -s, -c);    // down
  posed.X_GC.linear().col(2) = Eigen::Vector3d(0.0, c, -s);     // ahead
  posed.X_GC.translation() = Eigen::Vector3d(1.0, 2.0, 3.0);
  const auto json = jsonOf(posed, "camera/train/camera/camera_000000_000019_camera.json");
  EXPECT_EQ(json["intrinsic"]["fx"], 500.0);
  EXPECT_EQ(json["intrinsic"]["v0"], 240.0);
  EXPECT_EQ(jsonOf(zoomed(posed, 700.0),
                   "camera/train/camera/camera_000000_000019_camera.json")["intrinsic"]["fx"],
            700.0);
  EXPECT_EQ(json["extrinsic"]["z"], 3.0);
  EXPECT_NEAR(json["extrinsic"]["yaw"].get<double>(), 0.5 * M_PI, 1e-12);
  EXPECT_NEAR(json["extrinsic"]["pitch"].get<double>(), 0.1, 1e-12);
  EXPECT_NEAR(json["extrinsic"]["roll"].get<double>(), 0.0, 1e-12);
}

TEST_F(Cityscapes, TurnsACameraThatLooksStraightDownByItsYaw) {
  load({});
  Scene posed = scene(0, {});
  posed.X_GC.linear().col(0) = Eigen::Vector3d(1.0, 0.0, 0.0);   // right
  posed.X_GC.linear().col(1) = Eigen::Vector3d(0.0, -1.0, 0.0);  // down
  posed.X_GC.linear().col(2) = Eigen::Vector3d(0.0, 0.0, -1.0);  // ahead
  const auto json = jsonOf(posed, "camera/train/camera/camera_000000_000019_camera.json");
  EXPECT_NEAR(json["extrinsic"]["yaw"].get<double>(), 0.5 * M_PI, 1e-12);
  EXPECT_NEAR(json["extrinsic"]["pitch"].get<double>(), 0.5 * M_PI, 1e-12);
  EXPECT_NEAR(json["extrinsic"]["roll"].get<double>(), 0.0, 1e-12);
}

TEST_F(Cityscapes, WarnsOfALensThatTheCameraFileCannotHold) {
  const output::WriterHost& host = load({});
  Scene bent = scene(0, {});
  bent.camera = CameraModel(640, 480, {500.0, 500.0, 320.0, 240.0}, 0.05, 100.0,
                            {DistortionModel::kPlumbBob, {-0.01}});
  EXPECT_THAT(host.writeScene(bent).warnings, ElementsAre(HasSubstr("distortion")));
  EXPECT_THAT(host.writeScene(scene(0, {})).warnings, IsEmpty());
}

TEST_F(Cityscapes, WritesTheTableOfLabels) {
  load({{"world_id", 4}});
  runAll({scene(0, {})});
  const auto table = nlohmann::json::parse(test::readFile(folder() + "labels.json"));
  ASSERT_EQ(table.size(), 4U);
  EXPECT_EQ(table[0]["name"], "unlabeled");
  EXPECT_EQ(table[0]["trainId"], 255);
  EXPECT_EQ(table[1]["name"], "world");
  EXPECT_EQ(table[1]["id"], 4);
  EXPECT_EQ(table[3]["name"], "fork lift");
  EXPECT_EQ(table[3]["id"], 6);
  EXPECT_EQ(table[3]["trainId"], 2);
  EXPECT_EQ(table[3]["hasInstances"], true);
}

}  // namespace cityscapes_writer_test
}  // namespace synthetic_dataset
