#include "scene/camera_rig.h"

#include <iomanip>
#include <sstream>

#include <gmock/gmock.h>
#include <opencv2/calib3d.hpp>

#include "support/error_messages.h"
#include "support/fake_frame_source.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::scene {
namespace camera_rig_test {

using ::testing::ElementsAre;
using ::testing::StartsWith;

/// A camera of a world, whose file says that it sees from 0.2 to 30 m.
world::CameraSensor eye() {
  const CameraModel model(160, 120, {140, 140, 79.5, 59.5}, 0.2, 30.0);
  return {"mast::link::eye", Pose::Identity(), model, {}, "link", Pose::Identity()};
}

CameraRig rigOf(const CameraOptions& config) {
  base::Diagnostics found;
  return makeCameraRig(config, {}, {eye()}, {}, {}, test::FakeFrameSource(), found);
}

CameraOptions ofEye() {
  CameraOptions config;
  config.sensor = "mast::link::eye";
  return config;
}

TEST(CameraRig, OfTheWorldSeesAsFarAsItsFileSays) {
  const CameraModel model = rigOf(ofEye()).model;
  EXPECT_EQ(model.near(), 0.2);
  EXPECT_EQ(model.far(), 30.0);
}

TEST(CameraRig, OfTheWorldSeesAsFarAsIsSet) {
  CameraOptions config = ofEye();
  config.far = 5.0;
  const CameraModel model = rigOf(config).model;
  EXPECT_EQ(model.near(), 0.2);
  EXPECT_EQ(model.far(), 5.0);
  EXPECT_EQ(model.intrinsics(), eye().camera.intrinsics());
}

TEST(CameraRig, OfTheWorldIsRefusedWhereNothingWouldBeLeftToSee) {
  CameraOptions config = ofEye();
  config.near = 30.0;
  EXPECT_THAT(test::messagesOf([&] { (void)rigOf(config); }),
              ElementsAre(StartsWith("camera/near: found 30.0; the world's camera "
                                     "'mast::link::eye' sees from 0.2 to 30.0 m")));
}

TEST(CameraRig, FollowsItsFrameWhereThereIsOne) {
  CameraOptions config = ofEye();
  config.frame = "/mast/eye";
  const test::FakeFrameSource frames(
      {{"mast/eye", test::FakeFrameSource::fixed(Pose::Identity())}});
  base::Diagnostics found;
  const CameraRig rig = makeCameraRig(config, {}, {eye()}, {}, {}, frames, found);
  EXPECT_TRUE(rig.followsFrame());
  EXPECT_EQ(rig.followed, frames.find("mast/eye"));
}

/// A calibration in a file, whose camera stands 2 m above the ground and looks ahead.
class CalibratedRig : public ::testing::Test {
 protected:
  static constexpr const char* kMatrices =
      "header: {frame_id: stereo}\n"
      "width: 320\nheight: 240\nK: [300, 0, 159.5, 0, 300, 119.5, 0, 0, 1]\n"
      "D: [-0.2, 0.05, 0, 0, 0]\ndistortion_model: plumb_bob\n";

  CameraRig rigOf(const std::string& rest) {
    CameraOptions config;
    config.name = config.group = "right";
    config.frame_is_given = false;
    config.frame = "right/optical_link";
    config.info_file = folder.write("camera.yaml", kMatrices + rest).string();
    config.rectified = true;
    config.near = 0.1;
    config.far = 50.0;
    return makeCameraRig(config, {}, {}, {}, {}, frames, found);
  }

  const Pose X_GF = makePose({1.0, 2.0, 2.0}, Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5));
  test::FakeFrameSource frames{{{"stereo", test::FakeFrameSource::fixed(X_GF)}}};
  base::Diagnostics found;
  test::TemporaryFolder folder;
};

TEST_F(CalibratedRig, OfAStereoPairsRightCameraStandsBesideTheLeftOne) {
  // "For the right camera Tx = -fx' * B",
  // http://docs.ros.org/en/api/sensor_msgs/html/msg/CameraInfo.html
  const CameraRig rig = rigOf("P: [300, 0, 159.5, -60, 0, 300, 119.5, 0, 0, 0, 1, 0]\n");
  EXPECT_EQ(rig.frame, "stereo") << "as the file's header says";
  EXPECT_EQ(rig.optical_frame, "stereo/right");
  EXPECT_LT((rig.X_FC.translation() - Eigen::Vector3d(0.2, 0.0, 0.0)).norm(), 1e-12);
  EXPECT_TRUE(rig.model.isPinhole());
  notePictureFrames({rig}, found);
  EXPECT_THAT(found.messages(base::Severity::kNote),
              ElementsAre(testing::HasSubstr("stereo/right, at [0.2000, 0.0000, 0.0000] m")));
}

TEST_F(CalibratedRig, ProjectsPointsOfItsFrameByPTimesR) {
  const CameraRig rig = rigOf(
      "R: [0.9950041652780258, 0, 0.09983341664682815, 0, 1, 0, -0.09983341664682815, 0, "
      "0.9950041652780258]\nP: [310, 0, 150, -31, 0, 305, 110, 6.1, 0, 0, 1, 0]\n");
  Eigen::Matrix3d R;
  R << 0.9950041652780258, 0, 0.09983341664682815, 0, 1, 0, -0.09983341664682815, 0,
      0.9950041652780258;
  Eigen::Matrix<double, 3, 4> P;
  P << 310, 0, 150, -31, 0, 305, 110, 6.1, 0, 0, 1, 0;
  const Eigen::Vector3d p_F(-0.1, -0.05, 2.0);
  const Eigen::Vector3d truth = P * (R * p_F).homogeneous();
  const auto pixel = rig.model.project(rig.X_FC.inverse() * p_F);
  ASSERT_TRUE(pixel);
  EXPECT_LT((*pixel - truth.hnormalized()).norm(), 1e-9);
}

TEST_F(CalibratedRig, OfBothCamerasOfAPairShowsAPointInOneRow) {
  // Two cameras that are turned against each other, rectified by cv::stereoRectify.
  std::vector<double> K = {300, 0, 159.5, 0, 300, 119.5, 0, 0, 1};
  const cv::Mat matrix(3, 3, CV_64F, K.data());
  cv::Mat turn;
  cv::Rodrigues(cv::Vec3d(0.03, -0.05, 0.02), turn);
  cv::Mat R1, R2, P1, P2, Q;
  cv::stereoRectify(matrix, cv::Mat(), matrix, cv::Mat(), cv::Size(320, 240), turn,
                    cv::Vec3d(-0.2, 0.01, 0.005), R1, R2, P1, P2, Q);
  const auto listed = [](const cv::Mat& m) {
    std::ostringstream text;
    text << std::setprecision(17) << m.reshape(1, 1);
    return text.str();
  };
  std::vector<CameraRig> pair = {rigOf("R: " + listed(R1) + "\nP: " + listed(P1) + "\n"),
                                 rigOf("R: " + listed(R2) + "\nP: " + listed(P2) + "\n")};
  alignStereoPairs(pair);
  for (const Eigen::Vector3d& p_F :
       {Eigen::Vector3d(-0.3, 0.2, 2.0), Eigen::Vector3d(0.4, -0.3, 3.0)}) {
    const auto left = pair[0].model.project(pair[0].X_FC.inverse() * p_F);
    const auto right = pair[1].model.project(pair[1].X_FC.inverse() * p_F);
    ASSERT_TRUE(left && right);
    EXPECT_NEAR(left->y(), right->y(), 1e-9);
    // "disparity = fx B / z", with z in the rectified frame.
    const double z = (pair[0].X_FC.inverse() * p_F).z();
    EXPECT_NEAR(left->x() - right->x(), -P2.at<double>(0, 3) / z, 1e-9);
  }
}

TEST_F(CalibratedRig, OfAPairMayShareAPoseInsteadOfAFrame) {
  CameraRig left = rigOf(
      "R: [0.9950041652780258, 0, 0.09983341664682815, 0, 1, 0, -0.09983341664682815, 0, "
      "0.9950041652780258]\nP: [300, 0, 159.5, 0, 0, 300, 119.5, 0, 0, 0, 1, 0]\n");
  CameraRig right = rigOf("P: [300, 0, 159.5, -60, 0, 300, 119.5, 0, 0, 0, 1, 0]\n");
  left.frame = "left/optical_link";
  right.frame = "right/optical_link";
  std::vector<CameraRig> apart = {left, right};
  alignStereoPairs(apart);
  EXPECT_TRUE(apart[1].X_FC.linear().isIdentity());
  left.X_GC = right.X_GC = X_GF;
  std::vector<CameraRig> pair = {left, right};
  alignStereoPairs(pair);
  EXPECT_TRUE(pair[1].X_FC.linear().isApprox(left.X_FC.linear()));
  EXPECT_TRUE(pair[1].X_FC.translation().isApprox(left.X_FC * Eigen::Vector3d(0.2, 0.0, 0.0)));
}

TEST_F(CalibratedRig, IsWhereItsFrameIsWithoutRotationAndBaseline) {
  const CameraRig rig = rigOf(
      "R: [1, 0, 0, 0, 1, 0, 0, 0, 1]\nP: [300, 0, 159.5, 0, 0, 300, 119.5, 0, 0, 0, 1, 0]\n");
  EXPECT_EQ(rig.optical_frame, "stereo");
  EXPECT_TRUE(found.all().empty());
}

}  // namespace camera_rig_test
}  // namespace synthetic_dataset::scene
