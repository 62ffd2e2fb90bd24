#include <algorithm>
#include <cmath>
#include <sstream>

#include <gmock/gmock.h>
#include <opencv2/imgproc.hpp>

#include "plugins/plugin_harness.h"
#include "synthetic_dataset/mask.h"

namespace synthetic_dataset {
namespace ultralytics_writer_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;
using testing::StartsWith;

class Ultralytics : public PluginTest {
 protected:
  Ultralytics() : PluginTest("synthetic_dataset/UltralyticsYolo") {
    dataset_.classes = {{0, "robot"}, {2, "fork \"lift\""}};
    ObjectInfo robot;
    robot.keypoint_count = 2;
    robot.keypoint_names = {"front", "rear"};
    ObjectInfo lift;
    lift.class_id = 2;
    lift.keypoint_count = 1;
    lift.keypoint_names = {"mast"};
    dataset_.objects = {robot, lift};
  }

  /// The label file of a scene.
  [[nodiscard]] std::string labelsOf(std::vector<SceneObject> objects) const {
    return filesOf(scene(0, std::move(objects))).at("labels/train/00000000.txt");
  }

  [[nodiscard]] static SceneObject masked(const cv::Mat& mask) {
    SceneObject result = seen("a", maskBounds(mask));
    result.silhouette = result.visible_mask = Mask(mask);
    result.pixels.visible = cv::countNonZero(mask);
    return result;
  }

  /// The mask that Ultralytics makes from a line's polygon: points are truncated to whole pixels,
  /// and the polygon is filled with its rim.
  [[nodiscard]] static cv::Mat filled(const std::string& line) {
    std::vector<cv::Point> points;
    for (const cv::Point2d& point : pointsOf(line)) {
      points.emplace_back(static_cast<int>(point.x), static_cast<int>(point.y));
    }
    cv::Mat mask(480, 640, CV_8UC1, cv::Scalar(0));
    cv::fillPoly(mask, std::vector<std::vector<cv::Point>>{points}, 255);
    return mask;
  }

  /// The points of a line [px], in coordinates in which the image spans (0, 0) to (640, 480).
  [[nodiscard]] static std::vector<cv::Point2d> pointsOf(const std::string& line) {
    std::istringstream words(line);
    int class_id = -1;
    words >> class_id;
    std::vector<cv::Point2d> points;
    for (float x = 0, y = 0; words >> x >> y;) points.emplace_back(x * 640.0F, y * 480.0F);
    return points;
  }

  [[nodiscard]] static cv::Mat emptyMask() { return {480, 640, CV_8UC1, cv::Scalar(0)}; }

  /// Checks the mask that supervision makes from a line's polygon, with rounded points. Where the
  /// polygon touches the right or lower side of its box, it reaches a pixel out.
  static void expectRoundedMask(const std::string& line, const cv::Mat& mask) {
    std::vector<cv::Point> points;
    for (const cv::Point2d& point : pointsOf(line)) {
      points.emplace_back(static_cast<int>(std::nearbyint(point.x)),
                          static_cast<int>(std::nearbyint(point.y)));
    }
    cv::Mat rounded(480, 640, CV_8UC1, cv::Scalar(0));
    cv::fillPoly(rounded, std::vector<std::vector<cv::Point>>{points}, 255);
    EXPECT_EQ(cv::countNonZero(mask & ~rounded), 0) << line;
    EXPECT_LE(cv::countNonZero(rounded & ~mask), 2) << line;
  }

  void expectMaskComesBack(const cv::Mat& mask) {
    load({{"task", "segment"}});
    const std::string line = labelsOf({masked(mask)});
    EXPECT_EQ(cv::countNonZero(filled(line) != mask), 0) << line;
    expectRoundedMask(line, mask);
    const std::vector<cv::Point2d> points = pointsOf(line);
    EXPECT_GE(points.size(), 3U);
    const cv::Rect box = maskBounds(mask);
    const auto [left, right] = std::minmax_element(
        points.begin(), points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
    const auto [top, bottom] = std::minmax_element(
        points.begin(), points.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
    EXPECT_NEAR(left->x, box.x, 0.02);
    EXPECT_NEAR(right->x, box.br().x, 0.02);
    EXPECT_NEAR(top->y, box.y, 0.02);
    EXPECT_NEAR(bottom->y, box.br().y, 0.02);
  }
};

TEST_F(Ultralytics, WritesClassCentreAndSizeAsFractions) {
  load({{"task", "detect"}});
  // Pixels 128 to 191 and 72 to 167: centre (160, 120), size 64 x 96 of 640 x 480.
  EXPECT_EQ(labelsOf({seen("a", {128, 72, 64, 96})}),
            "0 0.25000000 0.25000000 0.10000000 0.20000000\n");
}

TEST_F(Ultralytics, WritesBoxesThatTouchTheImagesEdges) {
  load({{"task", "detect"}});
  EXPECT_EQ(labelsOf({seen("a", {0, 0, 640, 480})}),
            "0 0.50000000 0.50000000 1.00000000 1.00000000\n");
  // The last pixel: centre (639.5, 479.5), 1 x 1 pixel.
  EXPECT_EQ(labelsOf({seen("a", {639, 479, 1, 1})}),
            "0 0.99921875 0.99895833 0.00156250 0.00208333\n");
  // Of 20 x 20 pixels around the image's corner, 10 x 10 are in the image.
  EXPECT_EQ(labelsOf({seen("a", {-10, -10, 20, 20})}),
            "0 0.00781250 0.01041667 0.01562500 0.02083333\n");
}

TEST_F(Ultralytics, CutsTheOtherBoxesToTheImage) {
  SceneObject object = seen("a", {0, 0, 10, 10});
  object.silhouette_box = Box{-64.5, -0.5, 63.5, 47.5};
  object.loose_box = Box{-100.0, -50.0, 127.5, 95.5};
  load({{"task", "detect"}, {"box", "silhouette"}});
  EXPECT_EQ(labelsOf({object}), "0 0.05000000 0.05000000 0.10000000 0.10000000\n");
  load({{"task", "detect"}, {"box", "loose"}});
  EXPECT_EQ(labelsOf({object}), "0 0.10000000 0.10000000 0.20000000 0.20000000\n");
}

TEST_F(Ultralytics, WritesAnEmptyFileForAnImageWithoutLabels) {
  load({{"task", "detect"}});
  SceneObject dropped = seen("a", {5, 5, 2, 2});
  dropped.dropped = true;
  EXPECT_THAT(filesOf(scene(12, {dropped, seen("b", {900, 0, 5, 5})})),
              ElementsAre(Pair("images/train/00000012.png", "<image>"),
                          Pair("labels/train/00000012.txt", "")));
}

TEST_F(Ultralytics, GivesSplitsFoldersAndCamerasNames) {
  load({{"task", "detect"}, {"image_format", "jpg"}});
  Scene front = scene(3, {});
  front.name = "front/00000003";
  front.split = "val";
  EXPECT_THAT(filesOf(front), ElementsAre(Pair("images/val/front_00000003.jpg", "<image>"),
                                          Pair("labels/val/front_00000003.txt", "")));
}

TEST_F(Ultralytics, WritesManyObjects) {
  load({{"task", "detect"}});
  const SceneObject one = seen("a", {0, 0, 2, 2});
  const std::string labels = labelsOf(std::vector<SceneObject>(300, one));
  EXPECT_EQ(std::count(labels.begin(), labels.end(), '\n'), 300);
}

TEST_F(Ultralytics, WritesKeypointsAndFillsUpMissingOnes) {
  load({{"task", "pose"}});
  SceneObject robot = seen("a", {128, 72, 64, 96});
  robot.keypoints = {keypoint(Eigen::Vector2d(159.5, 119.5), 10.0, KeypointState::kVisible),
                     keypoint(Eigen::Vector2d(-0.5, 479.5), 10.0, KeypointState::kHiddenByItself)};
  SceneObject lift = robot;
  lift.class_id = 2;
  lift.keypoints = {keypoint(Eigen::Vector2d(319.5, 0.0), 10.0, KeypointState::kHiddenByAnother)};
  EXPECT_EQ(labelsOf({robot, lift}),
            "0 0.25000000 0.25000000 0.10000000 0.20000000"
            " 0.25000000 0.25000000 2 0.00000000 1.00000000 1\n"
            "2 0.25000000 0.25000000 0.10000000 0.20000000"
            " 0.50000000 0.00104167 1 0 0 0\n");
}

TEST_F(Ultralytics, WritesZerosForKeypointsThatAreNotOnTheImage) {
  load({{"task", "pose"}});
  SceneObject robot = seen("a", {128, 72, 64, 96});
  robot.keypoints = {keypoint(Eigen::Vector2d(-3.0, 5.0), 10.0, KeypointState::kOutside),
                     keypoint(std::nullopt, -1.0, KeypointState::kOutside)};
  EXPECT_THAT(labelsOf({robot}), HasSubstr(" 0.20000000 0 0 0 0 0 0\n"));
}

TEST_F(Ultralytics, WritesTheCornersOfTurnedBoxes) {
  load({{"task", "obb"}});
  EXPECT_EQ(labelsOf({seen("a", {128, 72, 64, 96})}),
            "0 0.20000000 0.15000000 0.30000000 0.15000000"
            " 0.30000000 0.35000000 0.20000000 0.35000000\n");
}

TEST_F(Ultralytics, WritesPolygonsThatAreTheMaskWhenFilled) {
  cv::Mat mask = emptyMask();
  mask(cv::Rect(100, 50, 80, 60)).setTo(255);
  mask(cv::Rect(120, 60, 10, 10)).setTo(0);  // a hole
  cv::circle(mask, {300, 200}, 77, 255, cv::FILLED);
  cv::line(mask, {170, 100}, {300, 200}, 255, 1);  // a bridge one pixel wide
  cv::circle(mask, {310, 190}, 20, 0, cv::FILLED);
  expectMaskComesBack(mask);
}

TEST_F(Ultralytics, WritesPolygonsOfTheWholeImage) { expectMaskComesBack(~emptyMask()); }

TEST_F(Ultralytics, WritesPolygonsOfMasksWithoutArea) {
  cv::Mat pixel = emptyMask();
  pixel.at<uchar>(479, 639) = 255;
  expectMaskComesBack(pixel);
  cv::Mat row = emptyMask();
  row(cv::Rect(0, 0, 640, 1)).setTo(255);
  expectMaskComesBack(row);
  cv::Mat diagonal = emptyMask();
  cv::line(diagonal, {20, 20}, {40, 40}, 255);
  expectMaskComesBack(diagonal);
}

TEST_F(Ultralytics, BridgesThePartsOfAMask) {
  load({{"task", "segment"}});
  cv::Mat mask = emptyMask();
  mask(cv::Rect(10, 10, 20, 20)).setTo(255);
  mask(cv::Rect(34, 10, 20, 20)).setTo(255);
  // One line; the bridge is a row of the four pixels in between.
  const std::string labels = labelsOf({masked(mask)});
  EXPECT_EQ(std::count(labels.begin(), labels.end(), '\n'), 1);
  const cv::Mat more = filled(labels) - mask;
  EXPECT_EQ(cv::countNonZero(mask - filled(labels)), 0);
  EXPECT_EQ(cv::countNonZero(more), 4);
}

TEST_F(Ultralytics, TellsTheLoaderWhatItNeeds) {
  load({{"task", "pose"}, {"flip_idx", Value::List{1, 0}}});
  Scene train = scene(0, {});
  train.split = "train";
  Scene val = scene(1, {});
  val.split = "val";
  Scene test = scene(2, {});
  test.split = "test";
  runAll({train, val, test});
  EXPECT_EQ(test::readFile(folder() + "data.yaml"),
            "# For Ultralytics: `yolo pose train data=/path/to/data.yaml`.\n"
            "# Ultralytics looks for the images beside this file: as there is no `path`, the "
            "folder can be moved.\n"
            "train: images/train\nval: images/val\ntest: images/test\n"
            "names:\n  0: \"robot\"\n  1: \"unused_1\"\n  2: \"fork \\\"lift\\\"\"\n"
            "kpt_shape: [2, 3]\nflip_idx: [1, 0]\n"
            "kpt_names:\n  0: [\"front\", \"rear\"]\n  1: [\"unused_0\", \"unused_1\"]\n"
            "  2: [\"mast\", \"unused_1\"]\n");
  EXPECT_THAT(
      test::readFile(folder() + "dataset.yaml"),
      StartsWith("# For FiftyOne, which looks for this name; the rest is that of data.yaml.\n"
                 "# Ultralytics looks for"));
}

TEST_F(Ultralytics, AKeypointHasTheColumnOfItsName) {
  ObjectInfo mirrored = dataset_.objects[0];
  mirrored.keypoint_names = {"rear", "front"};
  dataset_.objects.push_back(mirrored);
  load({{"task", "pose"}});
  const auto keypointed = [](const Eigen::Vector2d& first, const Eigen::Vector2d& second) {
    SceneObject object = seen("a", {100, 100, 50, 50});
    object.keypoints = {keypoint(first, 10.0, KeypointState::kVisible),
                        keypoint(second, 10.0, KeypointState::kVisible)};
    return object;
  };
  SceneObject robot = keypointed({110, 110}, {140, 140});
  robot.instance = 1;
  SceneObject other = keypointed({140, 140}, {110, 110});
  std::vector<SceneObject> objects = {robot, seen("b", {400, 100, 9, 9}), other};
  objects[1].class_id = 2;
  objects[1].keypoints = {keypoint(Eigen::Vector2d(404, 104), 10.0, KeypointState::kVisible)};
  std::istringstream lines(labelsOf(objects));
  std::string first;
  std::string second;
  std::getline(lines, first);
  std::getline(lines, second);
  std::getline(lines, second);
  EXPECT_EQ(first, second);
}

TEST_F(Ultralytics, TakesTheTrainingsImagesWhereThereAreNoneForValidation) {
  load({{"task", "detect"}});
  runAll({scene(0, {})});
  EXPECT_THAT(test::readFile(folder() + "data.yaml"),
              HasSubstr("\ntrain: images/train\nval: images/train  # the loader wants it"));
}

TEST_F(Ultralytics, NeedsATask) {
  load({});
  EXPECT_THAT(parameters_.errors(), ElementsAre(HasSubstr("w/task: required")));
  load({{"task", "segmnt"}});
  EXPECT_THAT(parameters_.errors(),
              ElementsAre(HasSubstr("w/task: found 'segmnt'; it should be detect, segment, pose or "
                                    "obb; did you mean 'segment'?")));
}

TEST_F(Ultralytics, NeedsKeypointsForPoses) {
  dataset_.objects.clear();
  load({{"task", "pose"}});
  EXPECT_THAT(parameters_.errors(), ElementsAre(HasSubstr("no object has keypoints")));
}

TEST_F(Ultralytics, RefusesFlipIndicesThatAreNoPermutation) {
  for (const Value::List& wrong :
       {Value::List{0}, Value::List{0, 0}, Value::List{0, 2}, Value::List{-1, 0}}) {
    load({{"task", "pose"}, {"flip_idx", wrong}});
    EXPECT_THAT(parameters_.errors(), ElementsAre(HasSubstr("w/flip_idx: found [")));
  }
}

TEST_F(Ultralytics, AsksForWhatItsTaskUses) {
  const Requirements detect = load({{"task", "detect"}}).requirements();
  EXPECT_TRUE(detect.visible_masks);
  EXPECT_FALSE(detect.visibility || detect.silhouettes || detect.keypoint_states);
  EXPECT_TRUE(load({{"task", "detect"}, {"box", "silhouette"}}).requirements().visibility);
  EXPECT_TRUE(load({{"task", "pose"}}).requirements().keypoint_states);
  EXPECT_TRUE(load({{"task", "segment"}, {"mask", "silhouette"}}).requirements().silhouettes);
}

TEST_F(Ultralytics, KnowsOnlyTheSettingsOfItsTask) {
  load({{"task", "segment"}, {"box", "visible"}});
  EXPECT_THAT(parameters_.unknownNames(), ElementsAre("w/box"));
  load({{"task", "detect"}, {"box", "visible"}, {"image_format", "png"}});
  EXPECT_THAT(parameters_.unknownNames(), IsEmpty());
}

}  // namespace ultralytics_writer_test
}  // namespace synthetic_dataset
