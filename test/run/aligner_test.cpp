/// Pictures whose camera's clock and frame differ from TF's by known amounts.

#include "run/align/aligner.h"
#include "run/live/json_values.h"

#include <cmath>
#include <filesystem>

#include <gmock/gmock.h>
#include <Eigen/Geometry>
#include <opencv2/imgcodecs.hpp>

#include "base/yaml_value.h"
#include "run_fixture.h"
#include "support/bag_builder.h"
#include "support/error_messages.h"

namespace synthetic_dataset::run {
namespace aligner_test {

using test::BagBuilder;
using test::milliseconds;
using test::poseAt;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Value yaml(const std::string& text) { return base::parseYaml(text, "test"); }

constexpr int kScenes = 30;
constexpr Duration kLate = std::chrono::milliseconds(37);

constexpr char kCamera[] = R"(image_width: 320
image_height: 240
camera_matrix: {rows: 3, cols: 3, data: [280, 0, 159.5, 0, 280, 119.5, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [-0.1, 0.02, 0, 0, 0]}
)";

/// The camera's pose in TF: 3 m before the objects, looking along x and a little down.
Pose recordedPose() {
  const Eigen::Quaterniond body(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY()));
  return makePose({-3.0, 0.1, 0.9}, body * Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5));
}

/// The error of that pose: 1.5 degrees and 3 cm.
Pose error() {
  const Eigen::Vector3d axis = Eigen::Vector3d(0.5, -0.7, 0.4).normalized();
  const double angle = 1.5 * std::acos(-1.0) / 180.0;
  return makePose(Eigen::Vector3d(0.02, -0.01, 0.02),
                  Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)));
}

class Align : public test::RunFixture {
 protected:
  /// @param moves  whether the objects move; otherwise they all stand still
  void record(bool moves) {
    run.folder().write("camera.yaml", kCamera);
    BagBuilder tf(run.folder() / "moving.bag");
    for (int i = 0; i <= 330; ++i) {
      const double s = moves ? 0.01 * i : 0.0;
      tf.move("map", "alpha/base_link", milliseconds(1000 + 10 * i),
              poseAt(-0.3 + 0.6 * std::sin(1.1 * s), 0.7 * std::cos(1.5 * s), 0.0, 0.9 * s));
      tf.move("map", "bravo/base_link", milliseconds(1000 + 10 * i),
              poseAt(0.6 * std::cos(0.8 * s), 0.8 * std::sin(1.3 * s), 0.4 - 0.3 * std::cos(s),
                     -0.7 * s));
    }
    const std::string moving = tf.close();
    parameters["bag_file"] = Value(moving);
    parameters["simulated_rate"] = Value(10.0);
    parameters["writers"] = yaml("[{name: boxes, type: synthetic_dataset/UltralyticsYolo}]");
    parameters["boxes"] = yaml("{task: detect, image_format: png}");
    setCamera(recordedPose() * error());
    Value::Map camera = *parameters.at("camera").as<Value::Map>();
    camera["effects"] = yaml("{blur: 0.8, noise_stddev: 0.02, exposure: -0.5}");
    parameters["camera"] = Value(camera);
    (void)generate();
    BagBuilder bag(run.folder() / "pictures.bag");
    for (int i = 0; i < kScenes; ++i) {
      const std::string number = (i < 10 ? "0000000" : "000000") + std::to_string(i);
      bag.picture("/eye", milliseconds(1000 + 100 * i) + kLate,
                  cv::imread(folder + "/boxes/images/train/" + number + ".png"), "bgr8");
    }
    parameters["bag_file"] = Value(Value::List{Value(moving), Value(bag.close())});
    parameters.erase("simulated_rate");
    setCamera(recordedPose());
    camera = *parameters.at("camera").as<Value::Map>();
    camera["image_topic"] = Value("/eye");
    parameters["camera"] = Value(camera);
  }

  void setCamera(const Pose& X_GC) {
    parameters["camera"] = Value(Value::Map{
        {"info_file", Value((run.folder() / "camera.yaml").string())}, {"pose", poseValue(X_GC)}});
  }
};

double turnBetween(const Pose& a, const Pose& b) {
  return Eigen::AngleAxisd((a.inverse() * b).linear()).angle() * 180.0 / std::acos(-1.0);
}

TEST_F(Align, FindsClockAndFrameOfTheCamera) {
  record(true);
  Reporter silent;
  const CameraAlignment found = alignCamera(Value(parameters), {kScenes}, silent);
  EXPECT_TRUE(found.knows_time);
  EXPECT_NEAR(toSeconds(found.time_offset), -0.037, 0.002);
  // In a picture, a few centimetres of shift look like a turn; both together are known better.
  EXPECT_LT(turnBetween(found.X_FD, error()), 0.15) << "degrees";
  EXPECT_LT((found.X_FD.translation() - error().translation()).norm(), 0.02);
  EXPECT_LT(found.stddev[kTimeEntry], 0.002);
  EXPECT_LT(*found.before, *found.after - 0.2);
}

TEST_F(Align, FindsTheFocalLengthWhenAsked) {
  record(true);
  Value::Map camera = *parameters.at("camera").as<Value::Map>();
  camera["focal_scale"] = Value(0.97);  // the calibration's is right
  parameters["camera"] = Value(camera);
  Reporter silent;
  const CameraAlignment found = alignCamera(Value(parameters), {kScenes, true}, silent);
  // Objects that are all about 3 m away determine it to a percent.
  EXPECT_NEAR(found.focal_scale, 1.0, 0.02);
  EXPECT_LT(found.stddev[kFocalEntry], 0.02) << "of objects that are 2.5 to 3.5 m away";
  EXPECT_LT(std::abs(found.focal_scale - 1.0), 4.0 * found.stddev[kFocalEntry]);
  EXPECT_NEAR(toSeconds(found.time_offset), -0.037, 0.002);
  EXPECT_LT(turnBetween(found.X_FD, error()), 0.15) << "degrees";
}

TEST_F(Align, SaysThatTimeIsUnknownWhereNothingMoves) {
  record(false);
  Reporter silent;
  const CameraAlignment found = alignCamera(Value(parameters), {kScenes}, silent);
  EXPECT_FALSE(found.knows_time);
  EXPECT_EQ(found.time_offset, Duration{0});
  EXPECT_GT(*found.after, *found.before);
}

TEST_F(Align, NeedsPictures) {
  Reporter silent;
  EXPECT_THAT(test::messagesOf([&] { (void)alignCamera(Value(parameters), {kScenes}, silent); }),
              ElementsAre(HasSubstr("camera/image_topic: is missing")));
}

}  // namespace aligner_test
}  // namespace synthetic_dataset::run
