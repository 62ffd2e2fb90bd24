#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/box.h"
#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset {
inline namespace v1 {

/// One labelled object at one instant. Frames: G global, C the camera's optical frame, O the
/// object.
struct SceneObject {
  std::string name;        ///< in TF and in the world
  std::string class_name;  ///< the parameter `class` as text
  std::string id;          ///< the parameter `id` as text

  Pose X_GO = Pose::Identity();
  Pose X_CO = Pose::Identity();
  std::vector<Eigen::Vector3d> keypoints_O;       ///< [m]
  std::vector<Eigen::Vector3d> bounding_shape_O;  ///< [m]

  /// The loose box [px]: round the projected bounding shape, clipped at the near plane but not cut
  /// to the image. Nothing when the whole shape is behind the camera.
  std::optional<Box> loose_box;

  /// Whether the loose box shares any area with the image.
  bool in_view = false;

  /// The instance mask: CV_8UC1 of the image's size, 255 on the object, 0 elsewhere, as if no other
  /// object were there; what the world hides of it is not in the mask. Empty unless a writer's
  /// requirements ask for instance masks.
  cv::Mat mask;
};

/// Everything known about one instant. Valid only during the call that it is given to; its images
/// share their pixels (cv::Mat), so copy what has to outlive the call.
struct Scene {
  /// Place in the run's plan, from 0 without gaps. With several cameras, each instant is as many
  /// scenes in a row.
  std::int64_t index = 0;

  /// What files of this scene are called, without extension: "00000012", and where the run has
  /// several cameras "<camera>/00000012", the number being that of the instant.
  std::string name;

  /// The camera's name: "camera" unless the parameters name it.
  std::string camera_name;

  Stamp stamp{0};

  CameraModel camera;
  Pose X_GC = Pose::Identity();

  /// The picture: CV_8UC3, channels in OpenCV's order (blue, green, red).
  cv::Mat image;

  std::vector<SceneObject> objects;  ///< in the order of `robot_list`

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
