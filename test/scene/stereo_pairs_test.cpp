#include "scene/stereo_pairs.h"

#include <iomanip>
#include <sstream>

#include <gmock/gmock.h>
#include <opencv2/calib3d.hpp>

#include "support/fake_frame_source.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::scene {
namespace stereo_pairs_test {

using ::testing::ElementsAre;

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
    return makeCameraRig(config, {}, {}, {}, {}, frames, diagnostics);
  }

  const Pose X_GF = makePose({1.0, 2.0, 2.0}, Eigen::Quaterniond(0.5, -0.5, 0.5, -0.5));
  test::FakeFrameSource frames{{{"stereo", test::FakeFrameSource::fixed(X_GF)}}};
  base::Diagnostics diagnostics;
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
  notePictureFrames({rig}, diagnostics);
  EXPECT_THAT(diagnostics.messages(base::Severity::kNote),
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
  // Two cameras that are rotated relative to each other, rectified by cv::stereoRectify.
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
  placeStereoPairs(pair, frames, diagnostics);
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
  placeStereoPairs(apart, frames, diagnostics);
  EXPECT_TRUE(apart[1].X_FC.linear().isIdentity());
  left.X_GC = right.X_GC = X_GF;
  std::vector<CameraRig> pair = {left, right};
  placeStereoPairs(pair, frames, diagnostics);
  EXPECT_TRUE(pair[1].X_FC.linear().isApprox(left.X_FC.linear()));
  EXPECT_TRUE(pair[1].X_FC.translation().isApprox(left.X_FC * Eigen::Vector3d(0.2, 0.0, 0.0)));
}

TEST_F(CalibratedRig, IsWhereItsFrameIsWithoutRotationAndBaseline) {
  const CameraRig rig = rigOf(
      "R: [1, 0, 0, 0, 1, 0, 0, 0, 1]\nP: [300, 0, 159.5, 0, 0, 300, 119.5, 0, 0, 0, 1, 0]\n");
  EXPECT_EQ(rig.optical_frame, "stereo");
  EXPECT_TRUE(diagnostics.all().empty());
}

TEST_F(CalibratedRig, WithAFrameOfItsOwnABaselineAwayIsThere) {
  // As in realsense2_camera: a frame camera_infra2_optical_frame, and P[3] as in a stereo pair.
  const std::string first = "P: [300, 0, 159.5, 0, 0, 300, 119.5, 0, 0, 0, 1, 0]\n";
  const std::string second = "P: [300, 0, 159.5, -60, 0, 300, 119.5, 0, 0, 0, 1, 0]\n";
  const Pose X_FS = makePose({0.2, 0.0, 0.0}, Eigen::Quaterniond::Identity());
  const test::FakeFrameSource two({{"stereo", test::FakeFrameSource::fixed(X_GF)},
                                   {"own", test::FakeFrameSource::fixed(X_GF * X_FS)},
                                   {"same", test::FakeFrameSource::fixed(X_GF)}});
  const auto placed = [&](const std::string& frame, StereoFrame stereo_frame) {
    std::vector<CameraRig> pair = {rigOf(first), rigOf(second)};
    pair[0].followed = *two.find("stereo");
    pair[1].frame = frame;
    pair[1].followed = *two.find(frame);
    pair[1].stereo_frame = stereo_frame;
    placeStereoPairs(pair, two, diagnostics);
    return pair[1];
  };
  const CameraRig own = placed("own", StereoFrame::kAuto);
  EXPECT_TRUE(own.X_FC.isApprox(Pose::Identity(), 0.0));
  EXPECT_EQ(own.optical_frame, "own");
  EXPECT_TRUE(diagnostics.all().empty());
  EXPECT_NEAR(placed("own", StereoFrame::kFirst).X_FC.translation().x(), 0.2, 1e-12);
  EXPECT_NEAR(placed("same", StereoFrame::kAuto).X_FC.translation().x(), 0.2, 1e-12);
  EXPECT_TRUE(placed("same", StereoFrame::kOwn).X_FC.translation().isZero(0.0));
}

TEST_F(CalibratedRig, OfASecondCameraAloneSaysWhoseFrameItTakesItToHave) {
  std::vector<CameraRig> alone = {rigOf("P: [300, 0, 159.5, -60, 0, 300, 119.5, 0, 0, 0, 1, 0]\n")};
  placeStereoPairs(alone, frames, diagnostics);
  EXPECT_NEAR(alone[0].X_FC.translation().x(), 0.2, 1e-12);
  EXPECT_THAT(diagnostics.messages(base::Severity::kWarning),
              ElementsAre(testing::AllOf(testing::HasSubstr("0.2000 m beside the first"),
                                         testing::HasSubstr("stereo_frame: own"))));
}

}  // namespace stereo_pairs_test
}  // namespace synthetic_dataset::scene
