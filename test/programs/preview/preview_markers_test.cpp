#include "programs/preview/preview_markers.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace synthetic_dataset::programs {
namespace preview_markers_test {

using visualization_msgs::Marker;

const ros_messages::SceneFrames kFrames("map", "preview/");

/// A camera one metre above the ground that looks down, and an object below it with one keypoint
/// seen and one hidden.
Scene sceneOf(const CameraModel& camera) {
  Scene scene(camera);
  scene.stamp = std::chrono::seconds(5);
  scene.X_GC = makePose({2.0, 3.0, 1.0}, Eigen::Quaterniond(0, 1, 0, 0));
  SceneObject object;
  object.name = "rover";
  object.class_name = "robot";
  object.instance = 1;
  object.X_GO = makePose({2.0, 3.0, 0.0}, Eigen::Quaterniond::Identity());
  object.keypoints_O = {{0.1, 0.0, 0.0}, {0.0, 0.2, 0.0}};
  object.keypoints.resize(2);
  object.keypoints[0].state = KeypointState::kVisible;
  object.keypoints[1].state = KeypointState::kHiddenByItself;
  object.bounding_shape_O = {{0.0, 0.0, 0.3}};
  object.cuboid_O = {{-0.1, -0.1, 0.0}, {0.1, 0.1, 0.3}};
  object.pixels.visible = 100;
  scene.objects.push_back(object);
  return scene;
}

const CameraModel kPinhole(640, 480, {500.0, 500.0, 319.5, 239.5}, 0.1, 50.0);

const Marker& markerOf(const visualization_msgs::MarkerArray& markers, const std::string& name) {
  return *std::find_if(markers.markers.begin(), markers.markers.end(),
                       [&](const Marker& each) { return each.ns == name; });
}

TEST(PreviewMarkers, ShowKeypointsAndShapesWhereTheyAre) {
  const auto markers = labelMarkers(sceneOf(kPinhole), kFrames);
  EXPECT_EQ(markers.markers.front().action, Marker::DELETEALL);
  const Marker& keypoints = markerOf(markers, "keypoints");
  EXPECT_EQ(keypoints.header.frame_id, "map");
  ASSERT_EQ(keypoints.points.size(), 2u);
  EXPECT_DOUBLE_EQ(keypoints.points[0].x, 2.1);
  EXPECT_DOUBLE_EQ(keypoints.points[1].y, 3.2);
  EXPECT_GT(keypoints.colors[0].g, keypoints.colors[0].r) << "it is seen";
  EXPECT_GT(keypoints.colors[1].r, keypoints.colors[1].g) << "it is hidden";
  EXPECT_DOUBLE_EQ(markerOf(markers, "bounding shapes").points.at(0).z, 0.3);
}

TEST(PreviewMarkers, ShowNoLabelOfWhatHasNone) {
  Scene scene = sceneOf(kPinhole);
  scene.objects.front().dropped = true;
  EXPECT_EQ(labelMarkers(scene, kFrames).markers.size(), 1u);
}

/// Per metre of depth, the corner of a pinhole's view is at (320 / 500, 240 / 500, 1) m from it.
TEST(PreviewMarkers, ShowWhatTheCameraSees) {
  const Marker view = viewMarker(sceneOf(kPinhole), kFrames);
  ASSERT_FALSE(view.points.empty());
  const double length = std::sqrt(0.64 * 0.64 + 0.48 * 0.48 + 1.0);
  const bool has_corner =
      std::any_of(view.points.begin(), view.points.end(), [&](const geometry_msgs::Point& point) {
        return std::abs(point.x - (2.0 + 0.64 / length)) < 1e-9 &&
               std::abs(point.y - (3.0 + 0.48 / length)) < 1e-9 &&
               std::abs(point.z - (1.0 - 1.0 / length)) < 1e-9;
      });
  EXPECT_TRUE(has_corner);
}

/// The corners of a fisheye's image see nothing.
TEST(PreviewMarkers, LeaveOutWhatALensDoesNotSee) {
  Distortion equidistant;
  equidistant.model = DistortionModel::kEquidistant;
  const CameraModel fisheye(640, 480, {120.0, 120.0, 319.5, 239.5}, 0.1, 50.0, equidistant);
  const Marker view = viewMarker(sceneOf(fisheye), kFrames);
  for (const geometry_msgs::Point& point : view.points) EXPECT_FALSE(std::isnan(point.x));
  EXPECT_EQ(view.points.size() % 2, 0u);
}

}  // namespace preview_markers_test
}  // namespace synthetic_dataset::programs
