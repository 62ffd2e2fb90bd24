/// Runs with several cameras, recorded calibrations and sensors' effects.

#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/yaml_value.h"
#include "run/scene_loop.h"
#include "run/setup/run_setup.h"
#include "run_fixture.h"
#include "support/bag_builder.h"
#include "support/fake_scene_sink.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::run {
namespace cameras_test {

namespace fs = std::filesystem;
using test::milliseconds;
using test::poseAt;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;

class CamerasTest : public test::RunFixture {
 protected:
  [[nodiscard]] fs::path file(const std::string& path) const { return run.folder() / "out" / path; }

  [[nodiscard]] cv::Mat picture(const std::string& path) const {
    return cv::imread(file(path).string());
  }

  Value::Map& camera() { return *parameters.at("camera").as<Value::Map>(); }
  void setEffects(const Value::Map& effects) { camera()["effects"] = Value(effects); }

  static Value vector(double x, double y, double z) {
    return Value(Value::List{Value(x), Value(y), Value(z)});
  }
  void aim(const Value::Map& pose) { camera()["pose"] = Value(pose); }

  /// The run's scenes, without a dataset.
  [[nodiscard]] std::vector<FinishedScene> scenesOf() const {
    Reporter silent;
    RunSetup setup = setUpRun(Value(parameters), {test::pluginXml()});
    test::FakeSceneSink sink;
    (void)SceneLoop(setup, sink, silent).run();
    return sink.scenes;
  }

  /// The column of the left edge of alpha, which is red, in a row of a picture.
  static double leftEdge(const cv::Mat& image, int row) {
    for (int u = 0; u < image.cols; ++u) {
      const cv::Vec3b pixel = image.at<cv::Vec3b>(row, u);
      if (pixel[2] > pixel[0] + 40) return u;
    }
    return -1.0;
  }

  /// A recording in which alpha crosses the view at 4 m/s.
  void recordFastAlpha() {
    test::BagBuilder bag(run.folder() / "tiny.bag");
    bag.fix("map", "bravo/base_link", milliseconds(1000), poseAt(4.0, 1.0, 0.0));
    for (int i = 0; i <= 20; ++i) {
      bag.move("map", "alpha/base_link", milliseconds(1000 + 50 * i), poseAt(0, 2.0 - 0.2 * i, 0));
    }
    bag.close();
  }
};

TEST_F(CamerasTest, EachCameraHasAFolderAndASceneATime) {
  Value::Map left = camera();
  Value::Map right = camera();
  (*right.at("pose").as<Value::List>())[1] = Value(-0.2);
  parameters.erase("camera");
  parameters["cameras"] = Value(Value::Map{{"left", Value(left)}, {"right", Value(right)}});
  const RunSummary summary = generate();
  EXPECT_EQ(summary.scenes, 8);
  EXPECT_EQ(summary.planned_scenes, 8);
  for (const std::string camera : {"left", "right"}) {
    EXPECT_TRUE(fs::exists(file("yolo/" + camera + "/00000000.png")));
    EXPECT_TRUE(fs::exists(file("yolo/" + camera + "/00000003.txt")));
    EXPECT_TRUE(fs::exists(file("stvnet/alpha/mask/" + camera + "/00000003.png")));
  }
  EXPECT_FALSE(fs::exists(file("yolo/left/00000004.png")));
  const std::string list = test::readFile(file("yolo/list.txt"));
  EXPECT_THAT(
      list, AllOf(HasSubstr("/yolo/left/00000000.png\n"), HasSubstr("/yolo/right/00000003.png\n")));
}

TEST_F(CamerasTest, ACameraAmongSeveralSeesWhatItSeesAlone) {
  generate();
  const std::string label = test::readFile(file("yolo/00000002.txt"));
  const std::string image = test::readFile(file("yolo/00000002.png"));
  const std::string mask = test::readFile(file("stvnet/bravo/mask/00000002.png"));
  Value::Map other = camera();
  (*other.at("pose").as<Value::List>())[1] = Value(-0.6);
  parameters["cameras"] = Value(Value::Map{{"a_first", Value(other)}, {"same", Value(camera())}});
  parameters.erase("camera");
  parameters["if_exists"] = Value("overwrite");
  generate();
  EXPECT_EQ(test::readFile(file("yolo/same/00000002.txt")), label);
  EXPECT_TRUE(test::readFile(file("yolo/same/00000002.png")) == image);
  EXPECT_TRUE(test::readFile(file("stvnet/bravo/mask/same/00000002.png")) == mask);
  EXPECT_NE(test::readFile(file("yolo/a_first/00000002.txt")), label);
}

TEST_F(CamerasTest, ARecordedCalibrationAndItsFrameMakeTheCamera) {
  generate();
  const std::string by_hand = test::readFile(file("yolo/00000000.png"));
  const Pose X_GC = makePose({-3.0, 0.2, 0.5}, Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5));
  test::BagBuilder bag(run.folder() / "tiny.bag");
  bag.calibrate("/eye/camera_info", "eye_optical", milliseconds(1000), 140);
  bag.fix("map", "eye_optical", milliseconds(1000), X_GC);
  bag.fix("map", "bravo/base_link", milliseconds(1000), poseAt(0, 1, 0));
  for (int i = 0; i <= 20; ++i) {
    bag.move("map", "alpha/base_link", milliseconds(1000 + 50 * i), poseAt(0, -0.5 + 0.05 * i, 0));
  }
  bag.close();
  parameters["camera"] = Value(Value::Map{{"info_topic", Value("/eye/camera_info")}});
  parameters["if_exists"] = Value("overwrite");
  generate();
  EXPECT_TRUE(test::readFile(file("yolo/00000000.png")) == by_hand);
}

TEST_F(CamerasTest, ASensorOfAnObjectRidesOnIt) {
  std::string world = test::readFile(run.folder() / "tiny.world");
  const std::string link = "<model name='alpha'><link name='body'>";
  world.replace(world.find(link), link.size(),
                link +
                    "<sensor name='eye' type='camera'><pose>0.3 0 0.3 0 0 0</pose><camera>"
                    "<horizontal_fov>1.2</horizontal_fov><image><width>160</width>"
                    "<height>120</height></image></camera></sensor>");
  run.folder().write("tiny.world", world);
  parameters["camera"] = Value(Value::Map{{"sensor", Value("alpha::body::eye")}});
  (*parameters.at("bounding_shape").as<Value::Map>())["output_frame"] =
      Value("camera/optical_link");
  generate();
  const auto bravoX = [&](const std::string& number) {
    const std::string text = test::readFile(file("bounding_shape/" + number + ".txt"));
    return std::stod(text.substr(text.find("bravo ") + 6));
  };
  // alpha goes 0.25 m to its left from scene to scene; bravo's first corner begins 1.3 m left of
  // it.
  EXPECT_NEAR(bravoX("00000000"), -1.3, 1e-4);
  EXPECT_NEAR(bravoX("00000001"), -1.05, 1e-4);
}

TEST_F(CamerasTest, ScenesThatAreExposedBeforeTheRecordingAreLeftOut) {
  setEffects({{"exposure_time", Value(0.02)}, {"motion_samples", Value(2)}});
  const RunSummary summary = generate();
  EXPECT_EQ(summary.scenes, 3) << "the first of four begins with the recording";
  EXPECT_EQ(summary.warnings.at("scene left out: a transform is not known at its time"), 1);
}

TEST_F(CamerasTest, ALensThatSeesLittleIsToldOf) {
  const std::string sound = test::readFile(run.folder() / "camera.yaml");
  const std::string numbers = "data: [0, 0, 0, 0, 0]";
  std::string folding = sound;
  folding.replace(folding.find(numbers), numbers.size(), "data: [-9.0, 0, 0, 0, 0]");
  run.folder().write("camera.yaml", folding);
  bool told = false;
  for (const auto& [kind, count] : generate().warnings) {
    told = told || kind.find("camera: its lens sees something in only") == 0;
  }
  EXPECT_TRUE(told);
}

TEST_F(CamerasTest, ACameraThatLooksAtAnObjectFollowsIt) {
  aim({{"position", vector(-3.0, 0.2, 1.5)}, {"look_at", Value("alpha")}});
  const auto scenes = scenesOf();
  ASSERT_EQ(scenes.size(), 4U);
  for (const FinishedScene& each : scenes) {
    const Eigen::Vector3d middle_C = *each.scene.objects[0].X_CO * Eigen::Vector3d(0, 0, 0.2);
    EXPECT_LT(middle_C.head<2>().norm(), 1e-9) << "on the optical axis in every scene";
    EXPECT_EQ(each.scene.X_GC.translation(), Eigen::Vector3d(-3.0, 0.2, 1.5));
    EXPECT_GT(-each.scene.X_GC.linear()(2, 1), 0.8) << "the image's up is the world's";
  }
  EXPECT_FALSE(scenes[0].scene.X_GC.isApprox(scenes[3].scene.X_GC)) << "alpha has moved";
}

TEST_F(CamerasTest, ACameraOnAnObjectLooksAtAnother) {
  aim({{"position", vector(0.0, 0.0, 1.0)}, {"look_at", Value("bravo")}});
  camera()["mounted_on"] = Value("alpha");
  for (const FinishedScene& each : scenesOf()) {
    const Eigen::Vector3d middle_C = *each.scene.objects[1].X_CO * Eigen::Vector3d(0, 0, 0.2);
    EXPECT_LT(middle_C.head<2>().norm(), 1e-9);
    const Eigen::Vector3d p_O = each.scene.objects[0].X_CO->inverse().translation();
    EXPECT_TRUE(p_O.isApprox(Eigen::Vector3d(0, 0, 1), 1e-9)) << "it rides along";
  }
}

TEST_F(CamerasTest, ACameraIsAimedAtAPointOrByAngles) {
  // The camera of the fixture looks along the global x.
  const Pose X_GC = scenesOf().front().scene.X_GC;
  aim({{"position", vector(-3.0, 0.2, 0.5)}, {"look_at", vector(2.0, 0.2, 0.5)}});
  EXPECT_TRUE(scenesOf().front().scene.X_GC.isApprox(X_GC, 1e-9));
  aim({{"position", vector(-3.0, 0.2, 0.5)}, {"rpy", vector(0.0, 0.0, 0.0)}});
  EXPECT_TRUE(scenesOf().front().scene.X_GC.isApprox(X_GC, 1e-9));
  // Turned to the left and then down: to +y, and below the horizon.
  aim({{"position", vector(-3.0, 0.2, 0.5)}, {"rpy", vector(0.0, 0.3, M_PI / 2.0)}});
  const Eigen::Vector3d ahead = scenesOf().front().scene.X_GC.linear().col(2);
  EXPECT_TRUE(ahead.isApprox(Eigen::Vector3d(0.0, std::cos(0.3), -std::sin(0.3)), 1e-9));
}

TEST_F(CamerasTest, ALookAtAnObjectThatIsNotThereIsRefused) {
  aim({{"position", vector(-3.0, 0.2, 0.5)}, {"look_at", Value("alpa")}});
  EXPECT_THAT(errors(), Contains(HasSubstr("camera/pose/look_at: found 'alpa'; it should be an "
                                           "object of robot_list (alpha, bravo) or a point "
                                           "[x, y, z]; did you mean 'alpha'?")));
}

TEST_F(CamerasTest, AListOfCamerasIsRefused) {
  parameters.erase("camera");
  parameters["cameras"] = Value(Value::List{Value("front")});
  EXPECT_THAT(errors(), Contains(HasSubstr("cameras: found")));
}

TEST_F(CamerasTest, ATopicThatIsNotRecordedIsNamed) {
  camera().erase("info_file");
  camera()["info_topic"] = Value("/eye/camera_info");
  EXPECT_THAT(errors(), Contains(HasSubstr("camera/info_topic: found '/eye/camera_info', a topic "
                                           "that the recording does not have")));
}

TEST_F(CamerasTest, MotionBlursWhatMovesAndLeavesTheRestAndTheLabels) {
  recordFastAlpha();
  generate();
  const cv::Mat sharp = picture("yolo/00000002.png");
  const std::string label = test::readFile(file("yolo/00000002.txt"));
  setEffects({{"exposure_time", Value(0.05)}, {"motion_samples", Value(8)}});
  parameters["if_exists"] = Value("overwrite");
  generate();
  // The first scene is exposed before the recording begins, and left out.
  const cv::Mat blurred = picture("yolo/00000001.png");
  EXPECT_EQ(test::readFile(file("yolo/00000001.txt")), label);
  // alpha's front, 2.8 m away, moves 0.2 m in the exposure: 10 px. In front of it is the floor.
  const int row = 75;
  const int edge = static_cast<int>(leftEdge(sharp, row));
  ASSERT_GT(edge, 10);
  const int before = sharp.at<cv::Vec3b>(row, edge + 2)[0];
  const int after = blurred.at<cv::Vec3b>(row, edge + 2)[0];
  EXPECT_GT(std::abs(after - before), 10);
  cv::Mat difference;
  cv::absdiff(sharp.rowRange(0, 30), blurred.rowRange(0, 30), difference);
  double most = 0;
  cv::minMaxLoc(difference.reshape(1), nullptr, &most);
  EXPECT_LE(most, 1.0) << "the background, up to rounding";
}

TEST_F(CamerasTest, ARollingShutterSkewsWhatCrossesTheView) {
  recordFastAlpha();
  setEffects({{"readout_time", Value(0.2)}, {"readout_bands", Value(120)}});
  generate();
  const cv::Mat image = picture("yolo/00000002.png");
  // Rows are 0.2 s / 120 apart, in which alpha's front moves 0.333 px to the right.
  const double upper = leftEdge(image, 66);
  const double lower = leftEdge(image, 80);
  ASSERT_GT(upper, 0);
  EXPECT_NEAR(lower - upper, 14 * 200.0 * 0.2 / 120, 1.1);
}

TEST_F(CamerasTest, LabelsOfARollingShutterAreThoseOfItsPicture) {
  recordFastAlpha();
  parameters["masks"] = base::parseYaml("{method: exact}", "test");
  generate();
  // With a readout time, the first scene would begin before the recording, so it is left out.
  const std::string still = test::readFile(file("stvnet/alpha/mask/00000003.png"));
  setEffects({{"readout_time", Value(0.2)}, {"readout_bands", Value(120)}});
  parameters["if_exists"] = Value("overwrite");
  for (const std::string method : {"exact", "mog2"}) {
    parameters["masks"] = base::parseYaml("{method: " + method + "}", "test");
    generate();
    const cv::Mat image = picture("yolo/00000002.png");
    const cv::Mat mask = cv::imread(file("stvnet/alpha/mask/00000002.png"), cv::IMREAD_GRAYSCALE);
    const cv::Rect bounds = cv::boundingRect(mask > 0);
    int compared = 0;
    for (int row = bounds.y + 2; row < bounds.br().y - 2; ++row) {
      const double edge = leftEdge(image, row);
      if (edge <= 0.0) continue;
      const cv::Mat here = mask.row(row) > 0;
      EXPECT_NEAR(cv::boundingRect(here).x, edge, 1.0) << method << ", row " << row;
      ++compared;
    }
    EXPECT_GT(compared, 10);
    // The box encloses the projected shape: it reaches as far as the mask, and little farther.
    std::istringstream label(test::readFile(file("yolo/00000002.txt")));
    std::string name;
    double centre = 0.0;
    double middle = 0.0;
    double width = 0.0;
    label >> name >> centre >> middle >> width;
    EXPECT_NEAR((centre - 0.5 * width) * image.cols - 0.5, bounds.x - 0.5, 3.0) << method;
    EXPECT_NEAR((centre + 0.5 * width) * image.cols - 0.5, bounds.br().x - 0.5, 3.0) << method;
  }
  parameters["masks"] = base::parseYaml("{method: exact}", "test");
  parameters["labels"] = base::parseYaml("{rolling_shutter: mid_exposure}", "test");
  generate();
  EXPECT_TRUE(test::readFile(file("stvnet/alpha/mask/00000002.png")) == still);
}

TEST_F(CamerasTest, NoiseIsInThePictureAndNotInTheMask) {
  generate();
  const cv::Mat clean = picture("yolo/00000001.png");
  const std::string mask = test::readFile(file("stvnet/alpha/mask/00000001.png"));
  setEffects({{"noise_stddev", Value(0.02)}});
  parameters["if_exists"] = Value("overwrite");
  generate();
  const cv::Mat noisy = picture("yolo/00000001.png");
  cv::Mat difference;
  cv::subtract(noisy, clean, difference, cv::noArray(), CV_32F);
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(difference.reshape(1), mean, deviation);
  EXPECT_NEAR(mean[0], 0.0, 0.2);
  EXPECT_NEAR(deviation[0], 0.02 * 255, 0.3);
  EXPECT_TRUE(test::readFile(file("stvnet/alpha/mask/00000001.png")) == mask);
}

TEST_F(CamerasTest, CamerasSeeTheSameDropsAndNewOnesAtEachInstant) {
  parameters["randomize"] =
      base::parseYaml("{weather: {snow: 3, colour: 1}, sensor: {exposure: 0}}", "test");
  parameters["cameras"] = Value(Value::Map{{"first", Value(camera())}, {"same", Value(camera())}});
  parameters.erase("camera");
  generate();
  const cv::Mat first = picture("yolo/first/00000001.png");
  EXPECT_EQ(cv::norm(first, picture("yolo/same/00000001.png"), cv::NORM_INF), 0.0);
  // Nothing else moves in the image's lower rows, on the floor.
  const cv::Rect floor(0, first.rows * 7 / 8, first.cols, first.rows / 8);
  const cv::Mat next = picture("yolo/first/00000002.png");
  EXPECT_GT(cv::norm(first(floor), next(floor), cv::NORM_INF), 10.0);
}

TEST_F(CamerasTest, AnExposureLongerThanThePeriodIsRefused) {
  setEffects({{"exposure_time", Value(0.2)}, {"readout_time", Value(0.1)}});
  EXPECT_THAT(errors(), Contains(AllOf(HasSubstr("camera/effects: found exposure_time + "
                                                 "readout_time of 0.3000 s"),
                                       HasSubstr("0.2500 s"))));
}

}  // namespace cameras_test
}  // namespace synthetic_dataset::run
