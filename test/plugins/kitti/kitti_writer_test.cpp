#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

#include <gmock/gmock.h>

#include "plugins/plugin_harness.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {
namespace kitti_writer_test {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::Pointwise;
using testing::StartsWith;

std::string contentOf(const std::string& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class Kitti : public PluginTest {
 protected:
  Kitti() : PluginTest("synthetic_dataset/Kitti") {
    dataset_.classes = {{0, "rover_class"}, {1, "fork lift"}};
  }

  /// A box of 4 x 2 x 1.5 m that stands upright at this bottom centre and is turned to the camera
  /// by `rotation_y`; it covers the pixels 100..149, 80..119.
  [[nodiscard]] static SceneObject upright(const Eigen::Vector3d& bottom_C, double rotation_y) {
    SceneObject object = seen("rover", {100, 80, 50, 40});
    object.cuboid_O = {{-2.0, -1.0, 0.0}, {2.0, 1.0, 1.5}};
    const double c = std::cos(rotation_y);
    const double s = std::sin(rotation_y);
    object.X_CO->linear() << c, s, 0.0, 0.0, 0.0, -1.0, -s, c, 0.0;
    object.X_CO->translation() = bottom_C;
    return object;
  }

  [[nodiscard]] std::string labelOf(const Scene& scene) const {
    return filesOf(scene).at("training/label_2/000000.txt");
  }

  /// The numbers behind the type in a label's only line.
  [[nodiscard]] std::vector<double> numbersOf(const SceneObject& object) const {
    std::istringstream line(labelOf(scene(0, {object})));
    std::string type;
    line >> type;
    return {std::istream_iterator<double>(line), {}};
  }
};

TEST_F(Kitti, WritesFifteenColumns) {
  load({});
  // The camera looks at its side: alpha = 0 - atan2(0, 10).
  EXPECT_EQ(labelOf(scene(0, {upright({0.0, 1.0, 10.0}, 0.0)})),
            "rover_class 0.000000 0 0.000000 100.000000 80.000000 150.000000 120.000000 1.500000 "
            "2.000000 4.000000 0.000000 1.000000 10.000000 0.000000\n");
}

TEST_F(Kitti, TurnsAboutTheCamerasDownwardAxis) {
  load({});
  // It drives away from the camera: its x axis is the camera's z, a turn by -90 degrees.
  const auto numbers = numbersOf(upright({10.0, 1.0, 10.0}, -M_PI / 2));
  EXPECT_NEAR(numbers[13], -1.570796, 1e-6);
  EXPECT_NEAR(numbers[2], -1.570796 - 0.785398, 1e-6);
}

TEST_F(Kitti, WrapsTheObservationAngle) {
  load({});
  // -170 degrees - 45 degrees = -215 = 145 degrees.
  const double degree = M_PI / 180.0;
  EXPECT_NEAR(numbersOf(upright({10.0, 0.0, 10.0}, -170 * degree))[2], 145 * degree, 1e-6);
}

TEST_F(Kitti, TellsABoxWhoseCornersAreTheObjectsOwn) {
  load({});
  const SceneObject object = upright({-3.0, 1.2, 8.0}, 0.7);
  const auto n = numbersOf(object);
  // The devkit's way back (matlab/computeBox3D.m): corners about the bottom centre, turned about y.
  const double c = std::cos(n[13]);
  const double s = std::sin(n[13]);
  std::size_t corner = 0;
  for (const double x : {-n[9] / 2, n[9] / 2}) {
    for (const double z : {-n[8] / 2, n[8] / 2}) {
      for (const double y : {0.0, -n[7]}) {
        const Eigen::Vector3d p_C(c * x + s * z + n[10], y + n[11], -s * x + c * z + n[12]);
        const auto expected = *object.X_CO * object.cuboid_O.corners()[corner++];
        EXPECT_LT((p_C - expected).norm(), 1e-5);
      }
    }
  }
}

TEST_F(Kitti, CutsBoxesToTheImageAndTellsTruncation) {
  load({{"box", "silhouette"}});
  // 20 of 50 columns are left of the image.
  SceneObject object = upright({0.0, 0.0, 5.0}, 0.0);
  const SceneObject cut = seen("rover", {-20, 80, 50, 40});
  object.silhouette_box = cut.silhouette_box();
  object.pixels = cut.pixels;
  const auto numbers = numbersOf(object);
  EXPECT_NEAR(numbers[0], 0.4, 1e-9);
  EXPECT_THAT(std::vector<double>(numbers.begin() + 3, numbers.begin() + 7),
              Pointwise(DoubleNear(1e-9), {0.0, 80.0, 30.0, 120.0}));
}

TEST_F(Kitti, TellsOcclusionOfThePartInTheImage) {
  load({});
  SceneObject object = upright({0.0, 0.0, 5.0}, 0.0);
  const auto occlusionAt = [&](std::int64_t visible) {
    object.pixels = counts(4000, 1000, visible);
    return numbersOf(object)[1];
  };
  EXPECT_EQ(occlusionAt(900), 0.0);
  EXPECT_EQ(occlusionAt(899), 1.0);
  EXPECT_EQ(occlusionAt(500), 1.0);
  EXPECT_EQ(occlusionAt(499), 2.0);
}

TEST_F(Kitti, MarksWhatTheThresholdsLeaveOutAsDontCare) {
  load({});
  SceneObject object = upright({0.0, 0.0, 5.0}, 0.0);
  object.dropped = true;
  EXPECT_EQ(labelOf(scene(0, {object})),
            "DontCare -1 -1 -10 100.000000 80.000000 150.000000 120.000000 -1 -1 -1 -1000 -1000 "
            "-1000 -10\n");
}

TEST_F(Kitti, LeavesDontCareOutWhenAsked) {
  load({{"dont_care", false}});
  SceneObject object = upright({0.0, 0.0, 5.0}, 0.0);
  object.dropped = true;
  EXPECT_EQ(labelOf(scene(0, {object})), "");
}

TEST_F(Kitti, SaysNothingOfAHiddenObject) {
  load({});
  EXPECT_EQ(labelOf(scene(0, {hidden(upright({0.0, 0.0, 5.0}, 0.0))})), "");
}

TEST_F(Kitti, WritesAnEmptyFileForASceneWithoutObjects) {
  load({});
  EXPECT_EQ(labelOf(scene(0, {})), "");
}

TEST_F(Kitti, NamesTypesAsAskedAndInOneWord) {
  load({{"class_names", Value::Map{{"rover_class", "Car"}}}});
  SceneObject lift = upright({0.0, 0.0, 5.0}, 0.0);
  lift.class_name = "fork lift";
  std::istringstream lines(labelOf(scene(0, {upright({0.0, 0.0, 5.0}, 0.0), lift})));
  std::string line;
  std::getline(lines, line);
  EXPECT_THAT(line, StartsWith("Car "));
  std::getline(lines, line);
  EXPECT_THAT(line, StartsWith("fork_lift "));
}

TEST_F(Kitti, RefusesTypesThatNoClassHasAndTypesWithSpaces) {
  load({{"class_names", Value::Map{{"rover_clas", "Car"}, {"fork lift", "a truck"}}},
        {"box", "tight"}});
  EXPECT_THAT(
      parameters_.errors(),
      ElementsAre("w/class_names/fork lift: found 'a truck'; it should be a word without spaces",
                  "w/class_names/rover_clas: no object has this class; did you mean "
                  "'rover_class'?",
                  HasSubstr("w/box: found 'tight'")));
}

TEST_F(Kitti, RefusesTwoClassesOfOneTypeAndDontCare) {
  dataset_.classes = {{0, "fork lift"}, {1, "fork_lift"}, {2, "x"}};
  load({{"class_names", Value::Map{{"x", "DontCare"}}}});
  EXPECT_THAT(
      parameters_.errors(),
      ElementsAre(HasSubstr("w/class_names/fork_lift: the class is called 'fork_lift' like "),
                  HasSubstr("w/class_names/x: found 'DontCare'")));
}

TEST_F(Kitti, WritesTheCameraOfEachImage) {
  load({});
  const std::string text = filesOf(scene(7, {})).at("training/calib/000007.txt");
  EXPECT_THAT(text, HasSubstr("P2: 500.000000 0.000000 320.000000 0.000000 0.000000 500.000000 "
                              "240.000000 0.000000 0.000000 0.000000 1.000000 0.000000\n"));
  EXPECT_THAT(text, HasSubstr("\nR0_rect: 1.000000 0.000000 0.000000 0.000000 1.000000"));
  EXPECT_THAT(text, HasSubstr("\nTr_velo_to_cam: 0.000000 -1.000000 0.000000 0.000000"));
  EXPECT_THAT(filesOf(zoomed(scene(8, {}), 700.0)).at("training/calib/000008.txt"),
              HasSubstr("P2: 700.000000 0.000000 320.000000 0.000000 0.000000 700.000000 "));
}

TEST_F(Kitti, WarnsOfObjectsTiltedByMoreThanADegree) {
  const output::WriterHost& host = load({});
  SceneObject object = upright({0.0, 0.0, 5.0}, 0.3);
  const auto tilt = [&](double degrees) {
    SceneObject tilted = object;
    tilted.X_CO->linear() =
        Eigen::AngleAxisd(degrees * M_PI / 180.0, Eigen::Vector3d::UnitX()) * object.X_CO->linear();
    return host.writeScene(scene(0, {tilted})).warnings;
  };
  EXPECT_THAT(tilt(0.9), IsEmpty());
  EXPECT_THAT(tilt(1.1), ElementsAre(HasSubstr("tilted against the camera")));
}

TEST_F(Kitti, WarnsOfALensThatTheFormatCannotExpress) {
  const output::WriterHost& host = load({});
  Distortion distortion;
  distortion.model = DistortionModel::kPlumbBob;
  const auto warningsWith = [&](const Distortion& lens) {
    Scene distorted = scene(0, {upright({0.0, 1.0, 10.0}, 0.0)});
    distorted.camera = CameraModel(640, 480, {500.0, 500.0, 320.0, 240.0}, 0.05, 100.0, lens);
    return host.writeScene(distorted).warnings;
  };
  EXPECT_THAT(warningsWith(distortion), IsEmpty());
  distortion.coefficients[0] = -0.1;
  EXPECT_THAT(warningsWith(distortion), ElementsAre(HasSubstr("no lens distortion")));
}

TEST_F(Kitti, ListsImagesByTheirSplit) {
  dataset_.splits = {{"train", 2}, {"val", 1}, {"test", 0}};
  load({});
  const SceneObject rover = upright({0.0, 1.0, 10.0}, 0.0);
  std::vector<Scene> scenes = {scene(0, {rover}), scene(1, {rover}), scene(2, {rover})};
  scenes[0].split = scenes[2].split = "train";
  scenes[1].split = "val";
  runAll(scenes);
  EXPECT_EQ(contentOf(folder() + "ImageSets/train.txt"), "000000\n000002\n");
  EXPECT_EQ(contentOf(folder() + "ImageSets/val.txt"), "000001\n");
  EXPECT_EQ(contentOf(folder() + "ImageSets/test.txt"), "");
  EXPECT_EQ(contentOf(folder() + "ImageSets/trainval.txt"), "000000\n000001\n000002\n");
}

TEST_F(Kitti, ListsAllImagesForTrainingWithoutSplits) {
  load({});
  const SceneObject rover = upright({0.0, 1.0, 10.0}, 0.0);
  runAll({scene(0, {rover}), scene(1, {rover})});
  EXPECT_EQ(contentOf(folder() + "ImageSets/train.txt"), "000000\n000001\n");
}

TEST_F(Kitti, ListsNoImageWithoutLabelsAsOpenPcdetCannotLoadIt) {
  const output::WriterHost& host = load({});
  SceneObject dropped = upright({0.0, 1.0, 10.0}, 0.0);
  dropped.dropped = true;  // DontCare
  const Scene empty = scene(1, {});
  runAll({scene(0, {upright({0.0, 1.0, 10.0}, 0.0)}), empty, scene(2, {dropped})});
  EXPECT_EQ(contentOf(folder() + "ImageSets/train.txt"), "000000\n000002\n");
  EXPECT_EQ(contentOf(folder() + "ImageSets/trainval.txt"), "000000\n000002\n");
  EXPECT_EQ(contentOf(folder() + "training/label_2/000001.txt"), "");
  EXPECT_THAT(host.writeScene(empty).warnings, ElementsAre(HasSubstr("left out of ImageSets")));
}

/// The numbers in the file of a scan.
std::vector<float> scanIn(const std::string& bytes) {
  std::vector<float> numbers(bytes.size() / sizeof(float));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(float));
  return numbers;
}

TEST_F(Kitti, WritesDepthAsAScannersPointsWhenAskedTo) {
  EXPECT_FALSE(load({}).requirements().depth);
  EXPECT_TRUE(load({{"velodyne", "depth"}}).requirements().depth);
  Scene near = scene(0, {});
  cv::Mat depth(480, 640, CV_32FC1, cv::Scalar(0));
  depth.at<float>(340, 520) = 5.0F;  // 200 px right of the axis and 100 px below it, f = 500 px
  near.depth = depth;
  const std::string path = "training/velodyne/000000.bin";
  // A millimetre behind the surface, which is 5.477 m away.
  EXPECT_THAT(scanIn(filesOf(near).at(path)),
              testing::Pointwise(testing::FloatNear(1e-5F),
                                 std::vector<float>{5.000913F, -2.000365F, -1.000183F, 0.0F}));
  near.camera = CameraModel(640, 480, {500.0, 500.0, 320.0, 240.0}, 0.05, 100.0,
                            {DistortionModel::kPlumbBob, {-0.1}});
  const std::vector<float> bent = scanIn(filesOf(near).at(path));
  const auto pixel = near.camera.project({-bent.at(1), -bent.at(2), bent.at(0)});
  EXPECT_NEAR(bent[0], 5.0009F, 1e-4);
  EXPECT_NEAR(pixel->x(), 520.0, 1e-3);
  EXPECT_NEAR(pixel->y(), 340.0, 1e-3);
}

/// OpenPCDet counts the points in each box.
TEST_F(Kitti, HasTheScansPointsOnABoxsFacesInIt) {
  load({{"velodyne", "depth"}});
  const SceneObject rover = upright({0.3, 1.0, 10.0}, 0.3);
  Scene near = scene(0, {rover});
  cv::Mat depth(480, 640, CV_32FC1, cv::Scalar(0));
  const Pose X_OC = rover.X_CO->inverse();
  for (int v = 150; v < 330; ++v) {  // where rays enter the box
    for (int u = 100; u < 540; ++u) {
      const Eigen::Vector3d ray_C((u - 320.0) / 500.0, (v - 240.0) / 500.0, 1.0);
      const Eigen::Vector3d from = X_OC.translation();
      const Eigen::Vector3d along = X_OC.linear() * ray_C;
      double enter = 0.0;
      double leave = 1e9;
      for (int i = 0; i < 3; ++i) {
        const double a = (rover.cuboid_O.low[i] - from[i]) / along[i];
        const double b = (rover.cuboid_O.high[i] - from[i]) / along[i];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
      }
      if (enter + 0.01 < leave) depth.at<float>(v, u) = static_cast<float>(enter);
    }
  }
  near.depth = depth;
  const std::vector<float> points = scanIn(filesOf(near).at("training/velodyne/000000.bin"));
  ASSERT_GT(points.size(), 4000U);
  for (std::size_t i = 0; i < points.size(); i += 4) {
    const Eigen::Vector3d p_O = X_OC * Eigen::Vector3d(-points[i + 1], -points[i + 2], points[i]);
    EXPECT_TRUE((p_O.array() > rover.cuboid_O.low.array()).all() &&
                (p_O.array() < rover.cuboid_O.high.array()).all())
        << p_O.transpose();
  }
}

/// OpenPCDet's and MMDetection3D's preparations open all lists, and expect `test` in `testing`.
TEST_F(Kitti, HasTheImagesOfTestInTestingToo) {
  dataset_.splits = {{"train", 1}, {"test", 1}};
  load({{"velodyne", "depth"}});
  std::vector<Scene> scenes = {scene(0, {upright({0.0, 1.0, 10.0}, 0.0)}),
                               scene(1, {upright({0.0, 1.0, 10.0}, 0.0)})};
  for (Scene& each : scenes) each.depth = cv::Mat(480, 640, CV_32FC1, cv::Scalar(3));
  scenes[1].split = "test";
  runAll(scenes);
  for (const char* file :
       {"image_2/000001.png", "calib/000001.txt", "label_2/000001.txt", "velodyne/000001.bin"}) {
    EXPECT_EQ(contentOf(folder() + "testing/" + file), contentOf(folder() + "training/" + file));
    EXPECT_THAT(contentOf(folder() + "testing/" + file), Not(IsEmpty())) << file;
  }
  EXPECT_EQ(contentOf(folder() + "testing/calib/000000.txt"), "");
  EXPECT_TRUE(std::ifstream(folder() + "ImageSets/val.txt").good());
}

TEST_F(Kitti, GivesEachOfSeveralCamerasAFolder) {
  dataset_.cameras = {{"front", "f", camera()}, {"rear left", "r", camera()}};
  load({});
  Scene front = scene(0, {upright({0.0, 1.0, 10.0}, 0.0)});
  front.name = "front/00000000";
  Scene rear = scene(1, {upright({0.0, 1.0, 10.0}, 0.0)});
  rear.name = "rear left/00000000";
  rear.instant = 0;
  rear.camera_index = 1;
  runAll({front, rear});
  const std::string rear_folder = folder() + safeFileName("rear left") + "/";
  EXPECT_THAT(contentOf(folder() + "front/training/image_2/000000.png"), Not(IsEmpty()));
  EXPECT_THAT(contentOf(rear_folder + "training/calib/000000.txt"), Not(IsEmpty()));
  EXPECT_EQ(contentOf(rear_folder + "ImageSets/train.txt"), "000000\n");
}

TEST_F(Kitti, FinishesADatasetWithoutScenes) {
  load({});
  runAll({});
  EXPECT_EQ(contentOf(folder() + "ImageSets/train.txt"), "");
}

TEST_F(Kitti, LabelsThreeHundredObjects) {
  load({});
  const std::string text =
      labelOf(scene(0, std::vector<SceneObject>(300, upright({0.0, 0.0, 5.0}, 0.0))));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 300);
}

TEST_F(Kitti, AsksForMasksAndMeasures) {
  const Requirements& requirements = load({}).requirements();
  EXPECT_TRUE(requirements.visible_masks);
  EXPECT_TRUE(requirements.visibility);
  EXPECT_FALSE(requirements.silhouettes);
}

}  // namespace kitti_writer_test
}  // namespace synthetic_dataset
