#include "label/keypoint_states.h"

#include <gtest/gtest.h>

#include "label/box_view.h"

namespace synthetic_dataset::label {
namespace keypoint_states_test {

using test::BoxView;
using test::SeenBox;

constexpr int kOwn = 3;
constexpr int kAnother = 7;
constexpr double kTolerance = 0.01;

const CameraModel kCamera(320, 240, {260.0, 262.0, 160.4, 119.2}, 0.05, 100.0);
const CameraModel kFisheye(300, 300, {90.1, 90.2, 149.8, 150.1}, 0.05, 100.0,
                           {DistortionModel::kEquidistant, {-0.01, 0.003}, 1.6581});

Pose pose(const Eigen::Vector3d& p, const Eigen::Quaterniond& q = Eigen::Quaterniond::Identity()) {
  return makePose(p, q);
}

/// A box that shows the camera three of its faces: -x, -y and -z.
SeenBox cornerOn(const Pose& X_CB = Pose::Identity()) {
  const Eigen::Quaterniond turned = Eigen::Quaterniond::FromTwoVectors(
      Eigen::Vector3d(-1, -0.8, -1.2), -Eigen::Vector3d::UnitZ());
  return {X_CB * pose({0.1, -0.1, 3}, turned), {0.8, 0.9, 1.0}, kOwn};
}

/// The state of a keypoint of the first box, given in that box's frame.
KeypointState stateOf(const Eigen::Vector3d& p_B, const std::vector<SeenBox>& boxes,
                      const CameraModel& camera = kCamera) {
  const BoxView seen = test::look(camera, boxes);
  const Eigen::Vector3d p_C = boxes[0].X_CB * p_B;
  std::vector<Keypoint> keypoints(1);
  keypoints[0].pixel = camera.project(p_C);
  const auto range = [&](const cv::Point& pixel) { return double{seen.range.at<float>(pixel)}; };
  findKeypointStates(keypoints, {p_C}, kOwn, seen.ids, range, camera, kTolerance);
  return keypoints[0].state();
}

TEST(KeypointStates, FacesAreSeenOrHiddenByTheBoxItself) {
  const SeenBox box = cornerOn();
  const Eigen::Vector3d half = 0.5 * box.size;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double a : {-0.7, 0.0, 0.6}) {
      for (const double side : {-1.0, 1.0}) {
        Eigen::Vector3d p = a * half;
        p[axis] = side * half[axis];
        EXPECT_EQ(stateOf(p, {box}),
                  side < 0.0 ? KeypointState::kVisible : KeypointState::kHiddenByItself)
            << "axis " << axis << ", side " << side << ", " << a;
      }
    }
  }
}

TEST(KeypointStates, CornersOfTheOutlineAreSeen) {
  const SeenBox box = cornerOn();
  const Eigen::Vector3d half = 0.5 * box.size;
  for (int i = 0; i < 7; ++i) {  // all but the one behind
    const Eigen::Vector3d corner((i & 4) != 0 ? half.x() : -half.x(),
                                 (i & 2) != 0 ? half.y() : -half.y(),
                                 (i & 1) != 0 ? half.z() : -half.z());
    EXPECT_EQ(stateOf(corner, {box}), KeypointState::kVisible) << i;
  }
  EXPECT_EQ(stateOf(half, {box}), KeypointState::kHiddenByItself);
}

TEST(KeypointStates, EdgesOfTheOutlineAreSeenAllAlong) {
  const SeenBox box = cornerOn();
  const Eigen::Vector3d half = 0.5 * box.size;
  for (double z = -0.95; z < 0.96; z += 0.05) {
    EXPECT_EQ(stateOf({half.x(), -half.y(), z * half.z()}, {box}), KeypointState::kVisible) << z;
  }
}

TEST(KeypointStates, InsideOfTheBodyIsHiddenByIt) {
  EXPECT_EQ(stateOf({0, 0, 0}, {cornerOn()}), KeypointState::kHiddenByItself);
}

TEST(KeypointStates, ALittleBelowTheSurfaceIsSeen) {
  const SeenBox box{pose({0, 0, 3}), {1, 1, 1}, kOwn};
  EXPECT_EQ(stateOf({0.1, 0.1, -0.5 + 0.8 * kTolerance}, {box}), KeypointState::kVisible);
  EXPECT_EQ(stateOf({0.1, 0.1, -0.5 + 1.3 * kTolerance}, {box}), KeypointState::kHiddenByItself);
  EXPECT_EQ(stateOf({0.1, 0.1, -0.7}, {box}), KeypointState::kVisible) << "before the surface";
}

TEST(KeypointStates, SteepFacesAreSeen) {
  // A long box whose side is seen at a few degrees: a pixel there is much longer than the
  // tolerance.
  const SeenBox box{pose({0.3, 0, 6}), {0.2, 0.5, 10}, kOwn};
  for (double z = -4.5; z < 4.6; z += 0.31) {
    EXPECT_EQ(stateOf({-0.1, 0.1, z}, {box}), KeypointState::kVisible) << z;
  }
}

TEST(KeypointStates, AThinPoleInFrontHides) {
  const SeenBox box{pose({0, 0, 3}), {1, 1, 1}, kOwn};
  const double width = 2.0 / 260.0 * 1.5;  // two pixels, 1.5 m away
  const double x = (180.5 - 160.4) / 260.0 * 1.5;
  for (const int id : {kAnother, 0}) {
    const SeenBox pole{pose({x, 0, 1.5}), {width, 2, width}, id};
    const auto at = [&](double u) {
      return stateOf({(u - 160.4) / 260.0 * 2.5, 0.1, -0.5}, {box, pole});
    };
    EXPECT_EQ(at(180.0), KeypointState::kHiddenByAnother) << id;
    EXPECT_EQ(at(181.0), KeypointState::kHiddenByAnother) << id;
    EXPECT_EQ(at(178.0), KeypointState::kVisible) << id;
    EXPECT_EQ(at(183.0), KeypointState::kVisible) << id;
  }
}

TEST(KeypointStates, OneBehindAStripOfItsOwnObjectIsHidden) {
  // Two plates of the object: beside the front one, a strip of the back one shows that is one
  // pixel wide. The step from plate to plate is not a slope.
  const auto plate = [](double z, double right_edge) {
    const double right = (right_edge - 160.4) / 260.0 * z;
    return SeenBox{pose({right - 0.5, 0, z}), {1, 1, 1e-3}, kOwn};
  };
  const SeenBox front = plate(1.8, 169.5);
  const SeenBox back = plate(2.14, 170.5);
  const double z = 2.42;
  const Eigen::Vector3d behind((170.0 - 160.4) / 260.0 * z, 0.1, z);
  EXPECT_EQ(stateOf(front.X_CB.inverse() * behind, {front, back}), KeypointState::kHiddenByItself);
  const Eigen::Vector3d on_strip(behind * 2.14 / z);
  EXPECT_EQ(stateOf(front.X_CB.inverse() * on_strip, {front, back}), KeypointState::kVisible);
}

TEST(KeypointStates, OneThroughAnothersHoleIsSeen) {
  const SeenBox box{pose({0, 0, 3}), {1, 1, 1}, kOwn};
  std::vector<SeenBox> boxes = {box};
  for (const double side : {-1.0, 1.0}) {
    boxes.push_back({pose({side * 0.2, 0, 1.5}), {0.3, 0.7, 0.02}, kAnother});
    boxes.push_back({pose({0, side * 0.2, 1.5}), {0.7, 0.3, 0.02}, kAnother});
  }
  EXPECT_EQ(stateOf({0, 0, -0.5}, boxes), KeypointState::kVisible);
  EXPECT_EQ(stateOf({0.2, 0, -0.5}, boxes), KeypointState::kHiddenByAnother);
}

TEST(KeypointStates, OneOnSteepGroundIsSeen) {
  // A box that stands on a floor seen at a low angle: its lower corners' pixels may show the floor,
  // which is much nearer within a pixel.
  const SeenBox box{pose({0.2, 0.4, 20}), {1, 1, 1}, kOwn};
  const SeenBox ground{pose({0, 1.9, 50}), {200, 2, 99}, 0};
  EXPECT_EQ(stateOf({-0.5, 0.5, -0.5}, {box, ground}), KeypointState::kVisible);
  EXPECT_EQ(stateOf({0.5, 0.5, -0.5}, {box, ground}), KeypointState::kVisible);
}

TEST(KeypointStates, OneBehindASlantedWallIsHidden) {
  // The wall is nearly edge on: within a pixel its distance changes by more than the keypoint's
  // distance behind it.
  const Eigen::Quaterniond slant(Eigen::AngleAxisd(1.45, Eigen::Vector3d::UnitY()));
  for (const int id : {kAnother, 0}) {
    const SeenBox wall{pose({0.0, 0.0, 12.0}, slant), {60.0, 40.0, 0.02}, id};
    int hidden = 0;
    for (double u = 20.0; u < 300.0; u += 7.3) {
      const Eigen::Vector3d ray((u - 160.4) / 260.0, 0.02, 1.0);
      const double to_wall = test::distanceTo(wall, ray.normalized());
      if (!std::isfinite(to_wall) || to_wall > 40.0) continue;
      for (const double behind : {0.1, 0.44}) {
        // So small that no part of it sticks out of the wall.
        const SeenBox box{
            pose(ray.normalized() * (to_wall + behind + 0.005)), {0.01, 0.01, 0.01}, kOwn};
        const Eigen::Vector3d p_B = box.X_CB.inverse() * (ray.normalized() * (to_wall + behind));
        EXPECT_EQ(stateOf(p_B, {box, wall}), KeypointState::kHiddenByAnother)
            << "column " << u << ", " << behind << " m behind";
        ++hidden;
      }
    }
    EXPECT_GT(hidden, 20);
  }
}

TEST(KeypointStates, OneOnGroundSeenByAFisheyeIsSeen) {
  const SeenBox box{pose({2.2, 0.4, 9}), {1, 1, 1}, kOwn};
  const SeenBox ground{pose({0, 1.9, 50}), {200, 2, 99}, 0};
  EXPECT_EQ(stateOf({-0.5, 0.5, -0.5}, {box, ground}, kFisheye), KeypointState::kVisible);
  EXPECT_EQ(stateOf({0.5, 0.5, -0.5}, {box, ground}, kFisheye), KeypointState::kVisible);
}

TEST(KeypointStates, OneBesideTheImageOrBehindTheCameraIsOutside) {
  const SeenBox box{pose({0, 0, 3}), {10, 1, 1}, kOwn};
  EXPECT_EQ(stateOf({4.9, 0, -0.5}, {box}), KeypointState::kOutside);
  EXPECT_EQ(stateOf({0, 0, -5.0}, {box}), KeypointState::kOutside);
  // The image ends half a pixel past the last pixel's centre.
  EXPECT_EQ(stateOf({(319.4 - 160.4) / 260.0 * 2.5, 0, -0.5}, {box}), KeypointState::kVisible);
  EXPECT_EQ(stateOf({(319.6 - 160.4) / 260.0 * 2.5, 0, -0.5}, {box}), KeypointState::kOutside);
}

TEST(KeypointStates, HoldBesideAFisheye) {
  // 93 degrees from the axis: z is negative.
  const Pose side =
      pose({0, 0, 0}, Eigen::Quaterniond(Eigen::AngleAxisd(1.62, Eigen::Vector3d::UnitY())));
  const SeenBox box{side * pose({0, 0, 3}), {1, 1, 1}, kOwn};
  const SeenBox cover{side * pose({0, 0.3, 1.5}), {0.6, 0.3, 0.1}, kAnother};
  EXPECT_EQ(stateOf({0, -0.2, -0.5}, {box, cover}, kFisheye), KeypointState::kVisible);
  EXPECT_EQ(stateOf({0, -0.2, 0.5}, {box, cover}, kFisheye), KeypointState::kHiddenByItself);
  EXPECT_EQ(stateOf({0, 0.45, -0.5}, {box, cover}, kFisheye), KeypointState::kHiddenByAnother);
}

}  // namespace keypoint_states_test
}  // namespace synthetic_dataset::label
