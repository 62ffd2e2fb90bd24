#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/box.h"
#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/cloud.h"
#include "synthetic_dataset/cuboid.h"
#include "synthetic_dataset/mask.h"
#include "synthetic_dataset/pose.h"
#include "synthetic_dataset/required.h"

namespace synthetic_dataset {
inline namespace v2 {

/// What the camera sees of a keypoint.
enum class KeypointState {
  kOutside,          ///< it has no place on the image
  kHiddenByAnother,  ///< something else stands in front of it: another object, or the world
  kHiddenByItself,   ///< its own object does
  kVisible,
};

/// One of an object's keypoints as the camera has it.
struct Keypoint {
  /// Where it falls [px], on the image or not; nothing behind the camera, and where the object is
  /// not in the scene.
  std::optional<Eigen::Vector2d> pixel;

  /// Its z in the optical frame, by the pose [m]; 0 where the object is not in the scene.
  double depth = 0.0;

  Required<KeypointState> state{"Keypoint::state", "keypoint_states"};
};

/// How many pixels an object has. Their centres are what counts.
struct PixelCounts {
  /// Of its silhouette, past the image's edge too.
  Required<std::int64_t> silhouette{"PixelCounts::silhouette", "visibility"};

  /// Of the part of its silhouette in the image, as if nothing hid it.
  Required<std::int64_t> silhouette_in_image{"PixelCounts::silhouette_in_image", "visibility"};

  /// That the camera sees. Known with `visible_masks` too.
  Required<std::int64_t> visible{"PixelCounts::visible", "visibility"};
};

/// One labelled object at one instant. Frames: G global, C the camera's optical frame, O the
/// object. What is Required is called: `object.silhouette()`.
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
  int instance = 0;        ///< its value in Scene::instance_map: its index in `robot_list`, from 1

  /// Its pose. Nothing where it is not in the scene: an object that is absent by chance, that does
  /// not take part in the scene's motion, or a distractor of another scene. Such an object has no
  /// pixels, no boxes and no keypoints in the image.
  std::optional<Pose> X_GO = Pose::Identity();
  std::optional<Pose> X_CO = Pose::Identity();

  std::vector<Eigen::Vector3d> keypoints_O;       ///< [m]
  std::vector<Eigen::Vector3d> bounding_shape_O;  ///< [m]

  std::vector<Keypoint> keypoints;  ///< of keypoints_O, in their order

  /// The smallest box along the object's axes around its visuals as its links stand; around the
  /// bounding shape where the model has none.
  Cuboid cuboid_O;

  /// The projected box [px]: around the projected bounding shape, clipped at the near plane but not
  /// cut to the image. Nothing when the whole shape is behind the camera.
  std::optional<Box> loose_box;

  /// The silhouette (amodal mask) in the image: the object as if nothing stood in front of it. With
  /// `masks/method: mog2`, what the static world hides is not in it either.
  Required<Mask> silhouette{"SceneObject::silhouette", "silhouettes"};

  /// The visible (modal) mask: where the camera sees the object.
  Required<Mask> visible_mask{"SceneObject::visible_mask", "visible_masks"};

  /// The tight box [px] around all pixels of the silhouette, past the image's edge too; nothing
  /// where there is none.
  Required<std::optional<Box>> silhouette_box{"SceneObject::silhouette_box", "visibility"};

  PixelCounts pixels;

  /// It is not in the scene, or too little of it is visible for the parameters
  /// `labels/min_visibility` and `labels/min_pixels`.
  bool dropped = false;

  /// Whether the projected box shares any area with the image.
  /// @param camera  the scene's
  [[nodiscard]] bool inView(const CameraModel& camera) const {
    return loose_box && intersection(*loose_box, camera.imageBounds());
  }

  /// The tight box [px] around the visible mask, from its first pixel's edge to its last one's;
  /// nothing where no pixel is visible.
  /// @throws Error unless visible masks are required
  [[nodiscard]] std::optional<Box> visibleBox() const;

  /// Visible pixels / pixels of the silhouette, the latter taken past the image's edge; 0 .. 1.
  /// @throws Error unless visibility is required
  [[nodiscard]] double visibility() const;

  /// The share of the silhouette outside the image, 0 .. 1.
  /// @throws Error unless visibility is required
  [[nodiscard]] double truncation() const;

  /// From the camera's centre to the origin of the object's frame [m].
  /// @throws Error where it is not in the scene
  [[nodiscard]] double distance() const;

  /// Whether it should have a label: it is in the scene, a pixel of it is visible, and the
  /// thresholds let it through.
  /// @throws Error unless visible masks or visibility are required
  [[nodiscard]] bool labelled() const { return pixels.visible() > 0 && !dropped && X_CO; }
};

/// Everything known about one instant through one camera. Valid only during the call that it is
/// given to; its images share their pixels (cv::Mat), so copy what has to outlive the call.
struct Scene {
  explicit Scene(const CameraModel& model) : camera(model) {}

  /// Index in the run's plan, from 0 without gaps. With several cameras, each instant is as many
  /// scenes in a row.
  std::int64_t index = 0;

  /// What files of this scene are called, without extension: "00000012", and where the run has
  /// several cameras "<camera>/00000012", the number being that of the instant.
  std::string name;

  /// The camera's name: "camera" unless the parameters name it.
  std::string camera_name;

  std::int64_t instant = 0;      ///< index of its time among the run's times
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

  // Pictures of the image's size.

  /// One pixel, one object: SceneObject::instance of the object that is seen, 0 for the world;
  /// CV_16UC1. The visible masks are its parts.
  Required<cv::Mat> instance_map{"Scene::instance_map", "visible_masks"};

  /// The class that is seen: its index in DatasetInfo::classes, from 1; 0 for the world; CV_16UC1.
  Required<cv::Mat> class_map{"Scene::class_map", "class_map"};

  /// The class of the world that is seen: its index in DatasetInfo::world_classes, from 1; 0 for
  /// objects, and for what is of none; CV_16UC1.
  Required<cv::Mat> world_map{"Scene::world_map", "world_map"};

  /// The part of its object that is seen: its index in ObjectInfo::part_names, from 1; 0 for what
  /// is of none, and for the world; CV_16UC1.
  Required<cv::Mat> part_map{"Scene::part_map", "part_map"};

  /// The z of what is seen, in the optical frame [m]; 0 where nothing is; CV_32FC1. Negative beside
  /// and behind a lens that sees past 90 degrees.
  ///
  /// With the parameter `camera/depth_noise`, as a depth camera measures it: with its noise
  /// (Nguyen, Izadi and Lovell 2012; Matthies and Shafer 1987), and 0 where it measures nothing. No
  /// other member depends on that.
  Required<cv::Mat> depth{"Scene::depth", "depth"};

  /// The unit normal of the surface that is seen, in the optical frame, towards the camera; 0 where
  /// nothing is; CV_32FC3 (x, y, z). Smooth where the mesh is: that of its vertices; without
  /// normal maps.
  Required<cv::Mat> normals{"Scene::normals", "normals"};

  /// Where what is seen has moved to in this camera's next scene, minus where it is [px]; CV_32FC2
  /// (u, v). NaN where nothing is, where it leaves what the camera can project, and all over the
  /// last scene.
  Required<cv::Mat> optical_flow{"Scene::optical_flow", "optical_flow"};

  /// What the lidars measure in their sweeps around the scene's stamp: one a lidar, the same in the
  /// scenes of all cameras.
  Required<Clouds> clouds{"Scene::clouds", "clouds"};

  /// The pose of frame `source` in frame `target` at the scene's time.
  /// Frames are those of TF; the camera's optical frame is known by `camera_frame_id`.
  /// @throws Error when the frames are not connected at this time, or not known; a frame that a
  ///     writer names in its requirements is
  [[nodiscard]] Pose transform(const std::string& target, const std::string& source) const;

  /// The folder of its split: "train" where the dataset has no splits.
  [[nodiscard]] std::string splitFolder() const { return split.empty() ? "train" : split; }

  /// Its name without folders, for formats that hold all images in one: "front_00000012".
  [[nodiscard]] std::string flatName() const;

  /// For who makes scenes: how `transform` knows poses.
  using Transforms = std::function<Pose(const std::string& target, const std::string& source)>;
  void setTransforms(Transforms transforms) { transforms_ = std::move(transforms); }

 private:
  Transforms transforms_;
};

}  // namespace v2
}  // namespace synthetic_dataset
