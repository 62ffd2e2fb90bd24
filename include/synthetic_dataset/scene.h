#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/box.h"
#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/cuboid.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset {
inline namespace v1 {

/// What the camera sees of a keypoint.
enum class KeypointState {
  kOutside,          ///< it has no place on the image
  kHiddenByAnother,  ///< something else stands in front of it: another object, or the world
  kHiddenByItself,   ///< its own object does
  kVisible,
};

/// One of an object's keypoints as the camera has it.
struct Keypoint {
  /// Where it falls [px], on the image or not; nothing behind the camera.
  std::optional<Eigen::Vector2d> pixel;

  double depth = 0.0;  ///< its z in the optical frame [m]

  /// kOutside or kVisible unless a writer's requirements ask for keypoint states.
  KeypointState state = KeypointState::kOutside;
};

/// How many pixels an object has. Their centres are what counts.
struct PixelCounts {
  std::int64_t silhouette = 0;           ///< of all of it, past the image's edge too
  std::int64_t silhouette_in_image = 0;  ///< of the part in the image, as if nothing hid it
  std::int64_t visible = 0;              ///< that the camera sees
};

/// One labelled object at one instant. Frames: G global, C the camera's optical frame, O the
/// object.
///
/// Its measures (`pixels`, `visibility`, `truncation`, `silhouette_box`) are exact whatever the
/// parameter `masks/method`: they are counted in the renderer's identifiers. Its masks and its
/// visible box are what that method finds.
struct SceneObject {
  std::string name;        ///< in TF and in the world
  std::string class_name;  ///< the name of its class in DatasetInfo::classes
  std::string class_text;  ///< the parameter `class` as text: the class's name or its number
  std::string id;          ///< the parameter `id` as text
  int class_id = 0;        ///< of its class in DatasetInfo::classes
  int instance = 0;        ///< its value in Scene::instance_map: its place in `robot_list`, from 1

  Pose X_GO = Pose::Identity();
  Pose X_CO = Pose::Identity();
  std::vector<Eigen::Vector3d> keypoints_O;       ///< [m]
  std::vector<Eigen::Vector3d> bounding_shape_O;  ///< [m]

  std::vector<Keypoint> keypoints;  ///< of keypoints_O, in their order

  /// The smallest box along the object's axes round its visuals as its links stand; round the
  /// bounding shape where the model has none.
  Cuboid cuboid_O;

  /// The loose box [px]: round the projected bounding shape, clipped at the near plane but not cut
  /// to the image. Nothing when the whole shape is behind the camera.
  std::optional<Box> loose_box;

  /// Whether the loose box shares any area with the image.
  bool in_view = false;

  /// The silhouette (amodal mask): CV_8UC1 of the image's size, 255 on the object as if nothing
  /// stood in front of it, 0 elsewhere. With `masks/method: mog2`, what the static world hides is
  /// not in it either. Empty unless required.
  cv::Mat silhouette;

  /// The visible (modal) mask: CV_8UC1 of the image's size, 255 where the camera sees the object,
  /// 0 elsewhere. Empty unless required.
  cv::Mat visible_mask;

  /// Tight boxes [px] round all pixels, from the first one's edge to the last one's; nothing where
  /// there is no pixel. That of the silhouette reaches past the image's edge.
  std::optional<Box> silhouette_box;
  std::optional<Box> visible_box;

  PixelCounts pixels;

  /// Visible pixels / pixels of the silhouette, the latter taken past the image's edge; 0 .. 1.
  double visibility = 0.0;

  /// The share of the silhouette outside the image, 0 .. 1.
  double truncation = 0.0;

  /// Too little of it is visible for the parameters `labels/min_visibility` and
  /// `labels/min_pixels`; false where these are not set.
  bool dropped = false;

  /// From the camera's centre to the origin of the object's frame [m].
  [[nodiscard]] double distance() const { return X_CO.translation().norm(); }

  /// Whether it should have a label: a pixel of it is visible, and the thresholds let it through.
  /// Known where the requirements ask for visible masks or visibility.
  [[nodiscard]] bool labelled() const { return pixels.visible > 0 && !dropped; }
};

/// Everything known about one instant. Valid only during the call that it is given to; its images
/// share their pixels (cv::Mat), so copy what has to outlive the call.
struct Scene {
  explicit Scene(const CameraModel& model) : camera(model) {}

  /// Place in the run's plan, from 0 without gaps. With several cameras, each instant is as many
  /// scenes in a row.
  std::int64_t index = 0;

  /// What files of this scene are called, without extension: "00000012", and where the run has
  /// several cameras "<camera>/00000012", the number being that of the instant.
  std::string name;

  /// The camera's name: "camera" unless the parameters name it.
  std::string camera_name;

  std::int64_t instant = 0;      ///< place of its time among the run's times, from 0
  std::size_t camera_index = 0;  ///< in DatasetInfo::cameras

  /// The split that it belongs to ("train", "val", "test"); empty where the parameters have none.
  /// The scenes of one instant are in one split.
  std::string split;

  Stamp stamp{0};

  CameraModel camera;
  Pose X_GC = Pose::Identity();

  /// The picture: CV_8UC3, channels in OpenCV's order (blue, green, red).
  cv::Mat image;

  std::vector<SceneObject> objects;  ///< in the order of `robot_list`

  // Pictures of the image's size, empty unless required.

  /// One pixel, one object: SceneObject::instance of the object that is seen, 0 for the world;
  /// CV_16UC1. The visible masks are its parts.
  cv::Mat instance_map;

  /// The class that is seen: its place in DatasetInfo::classes, from 1; 0 for the world; CV_16UC1.
  cv::Mat class_map;

  /// The z of what is seen, in the optical frame [m]; 0 where nothing is; CV_32FC1. Negative beside
  /// and behind a lens that sees past 90 degrees.
  cv::Mat depth;

  /// The unit normal of the surface that is seen, in the optical frame, towards the camera; 0 where
  /// nothing is; CV_32FC3 (x, y, z). Smooth where the mesh is: that of its vertices; without
  /// normal maps.
  cv::Mat normals;

  /// Where what is seen has moved to in this camera's next scene, minus where it is [px]; CV_32FC2
  /// (u, v). NaN where nothing is, where it leaves what the camera can project, and all over the
  /// last scene.
  cv::Mat optical_flow;

  /// The pose of frame `source` in frame `target` at the scene's time.
  /// Frames are those of TF; the camera's optical frame is known by `camera_frame_id`.
  /// @throws Error when the frames are not connected at this time; a frame that a writer names in
  ///     its requirements is.
  [[nodiscard]] Pose transform(const std::string& target, const std::string& source) const {
    return lookup(target, source);
  }

  std::function<Pose(const std::string& target, const std::string& source)> lookup;
};

}  // namespace v1
}  // namespace synthetic_dataset
