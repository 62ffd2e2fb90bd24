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

/// Whether the camera sees a keypoint and, if not, why.
enum class KeypointState {
  kOutside,          ///< it is not in the image
  kHiddenByAnother,  ///< something else is in front of it: another object, or the world
  kHiddenByItself,   ///< its own object is in front of it
  kVisible,
};

/// One of an object's keypoints as the camera sees it.
struct Keypoint {
  /// Its projection [px], inside the image or not; nullopt if it is behind the camera or the object
  /// is not in the scene.
  std::optional<Eigen::Vector2d> pixel;

  /// Its z in the optical frame [m], from the pose; 0 if the object is not in the scene.
  double depth = 0.0;

  Required<KeypointState> state{"Keypoint::state", "keypoint_states"};
};

/// How many pixels an object covers. A pixel counts if its centre is covered.
struct PixelCounts {
  /// In its silhouette, including those beyond the image's edge.
  Required<std::int64_t> silhouette{"PixelCounts::silhouette", "visibility"};

  /// In the part of its silhouette inside the image, as if nothing hid it.
  Required<std::int64_t> silhouette_in_image{"PixelCounts::silhouette_in_image", "visibility"};

  /// Visible to the camera. Also known with `visible_masks`.
  Required<std::int64_t> visible{"PixelCounts::visible", "visibility"};
};

/// One labelled object at one instant. Frames: G global, C the camera's optical frame, O the
/// object. Members of type Required are read by calling them: `object.silhouette()`.
///
/// Its measures (`pixels`, `visibility`, `truncation`, `silhouette_box`) are exact whatever the
/// parameter `masks/method`: they are counted in the renderer's identifier images. Its masks and
/// its visible box are what that method finds.
struct SceneObject {
  std::string name;        ///< in TF and in the world
  std::string class_name;  ///< the name of its class in DatasetInfo::classes
  std::string class_text;  ///< the parameter `class` as text: the class's name or its number
  std::string id;          ///< the parameter `id` as text
  int class_id = 0;        ///< of its class in DatasetInfo::classes
  int instance = 0;        ///< its value in Scene::instance_map: its index in `robot_list`, from 1

  /// Its pose; nullopt if it is not in the scene: an object that is absent by chance, that does not
  /// take part in the scene's motion, or a distractor of another scene. Such an object has no
  /// pixels, no boxes and no keypoints in the image.
  std::optional<Pose> X_GO = Pose::Identity();
  std::optional<Pose> X_CO = Pose::Identity();

  std::vector<Eigen::Vector3d> keypoints_O;       ///< [m]
  std::vector<Eigen::Vector3d> bounding_shape_O;  ///< [m]

  std::vector<Keypoint> keypoints;  ///< of keypoints_O, in their order

  /// The smallest box aligned with the object's axes around its visuals, with its links as posed in
  /// the scene; around the bounding shape if the model has no visuals.
  Cuboid cuboid_O;

  /// The box [px] around the projected bounding shape, clipped at the near plane but not cut to the
  /// image; nullopt if the whole shape is behind the camera.
  std::optional<Box> loose_box;

  /// The silhouette (amodal mask) in the image: the object as if nothing were in front of it. With
  /// `masks/method: mog2`, it excludes what the static world hides.
  Required<Mask> silhouette{"SceneObject::silhouette", "silhouettes"};

  /// The visible (modal) mask: where the camera sees the object.
  Required<Mask> visible_mask{"SceneObject::visible_mask", "visible_masks"};

  /// The tight box [px] around all pixels of the silhouette, including those beyond the image's
  /// edge; nullopt if there are none.
  Required<std::optional<Box>> silhouette_box{"SceneObject::silhouette_box", "visibility"};

  PixelCounts pixels;

  /// Whether it is not in the scene, or too little of it is visible for the parameters
  /// `labels/min_visibility` and `labels/min_pixels`.
  bool dropped = false;

  /// Whether the projected box shares any area with the image.
  /// @param camera  the scene's
  [[nodiscard]] bool inView(const CameraModel& camera) const {
    return loose_box && intersection(*loose_box, camera.imageBounds());
  }

  /// The tight box [px] around the visible mask, along the outer edges of its pixels; nullopt if no
  /// pixel is visible.
  /// @throws Error unless visible masks are required
  [[nodiscard]] std::optional<Box> visibleBox() const;

  /// Visible pixels / all silhouette pixels, including those beyond the image's edge; 0 .. 1.
  /// @throws Error unless visibility is required
  [[nodiscard]] double visibility() const;

  /// The share of the silhouette outside the image, 0 .. 1.
  /// @throws Error unless visibility is required
  [[nodiscard]] double truncation() const;

  /// From the camera's centre to the origin of the object's frame [m].
  /// @throws Error if it is not in the scene
  [[nodiscard]] double distance() const;

  /// Whether it should have a label: it is in the scene, a pixel of it is visible, and it passes
  /// the thresholds.
  /// @throws Error unless visible masks or visibility are required
  [[nodiscard]] bool labelled() const { return pixels.visible() > 0 && !dropped && X_CO; }
};

/// Everything known about one instant as seen by one camera. Valid only during the call that
/// receives it; its images share their pixels (cv::Mat), so copy what has to outlive the call.
struct Scene {
  explicit Scene(const CameraModel& model) : camera(model) {}

  /// Index in the run's plan, from 0 without gaps. With several cameras, each instant gives one
  /// scene per camera, with consecutive indices.
  std::int64_t index = 0;

  /// The name of this scene's files without extension: "00000012", or "<camera>/00000012" if the
  /// run has several cameras; the number is that of the instant.
  std::string name;

  /// The camera's name: "camera" unless the parameters name it.
  std::string camera_name;

  std::int64_t instant = 0;      ///< index of its time among the run's times
  std::size_t camera_index = 0;  ///< in DatasetInfo::cameras

  /// The split that it belongs to ("train", "val", "test"); empty if the parameters define none.
  /// The scenes of one instant are in one split.
  std::string split;

  Stamp stamp{0};

  CameraModel camera;
  Pose X_GC = Pose::Identity();

  /// The picture: CV_8UC3, channels in OpenCV's order (blue, green, red).
  cv::Mat image;

  std::vector<SceneObject> objects;  ///< in the order of `robot_list`

  // Maps of the image's size.

  /// SceneObject::instance of the object visible at each pixel, 0 for the world; CV_16UC1. The
  /// visible masks are parts of it.
  Required<cv::Mat> instance_map{"Scene::instance_map", "visible_masks"};

  /// The visible class: its index in DatasetInfo::classes, from 1; 0 for the world; CV_16UC1.
  Required<cv::Mat> class_map{"Scene::class_map", "class_map"};

  /// The visible class of the world: its index in DatasetInfo::world_classes, from 1; 0 for objects
  /// and for what belongs to no class; CV_16UC1.
  Required<cv::Mat> world_map{"Scene::world_map", "world_map"};

  /// The visible part of an object: its index in ObjectInfo::part_names, from 1; 0 for what belongs
  /// to no part and for the world; CV_16UC1.
  Required<cv::Mat> part_map{"Scene::part_map", "part_map"};

  /// The z of the visible surface in the optical frame [m]; 0 where there is none; CV_32FC1.
  /// Negative beyond 90 degrees from the axis of a lens that sees that far.
  ///
  /// With the parameter `camera/depth_noise`, the z that a depth camera measures: with its noise
  /// (Nguyen, Izadi and Lovell 2012; Matthies and Shafer 1987), and 0 where it measures nothing. No
  /// other member is affected.
  Required<cv::Mat> depth{"Scene::depth", "depth"};

  /// The unit normal of the visible surface in the optical frame, towards the camera; 0 where there
  /// is none; CV_32FC3 (x, y, z). Smooth where the mesh is, from its vertex normals; normal maps
  /// are ignored.
  Required<cv::Mat> normals{"Scene::normals", "normals"};

  /// The position of each visible point in this camera's next scene minus its position in this one
  /// [px]; CV_32FC2 (u, v). NaN where there is no surface, where the point moves to where the
  /// camera cannot project it, and everywhere in the last scene.
  Required<cv::Mat> optical_flow{"Scene::optical_flow", "optical_flow"};

  /// The lidar sweeps around the scene's stamp: one per lidar, shared by the scenes of all cameras.
  Required<Clouds> clouds{"Scene::clouds", "clouds"};

  /// The pose of frame `source` in frame `target` at the scene's time.
  /// Frames are those of TF; the camera's optical frame is the one named by `camera_frame_id`.
  /// @throws Error if the frames are not connected at this time or not known; frames that a writer
  ///     names in its requirements always are
  [[nodiscard]] Pose transform(const std::string& target, const std::string& source) const;

  /// The folder of its split: "train" if the dataset has no splits.
  [[nodiscard]] std::string splitFolder() const { return split.empty() ? "train" : split; }

  /// Its name without folders, for formats that keep all images in one folder: "front_00000012".
  [[nodiscard]] std::string flatName() const;

  /// For code that builds scenes: sets the function that `transform` calls.
  using Transforms = std::function<Pose(const std::string& target, const std::string& source)>;
  void setTransforms(Transforms transforms) { transforms_ = std::move(transforms); }

 private:
  Transforms transforms_;
};

}  // namespace v2
}  // namespace synthetic_dataset
