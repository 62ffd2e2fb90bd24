#pragma once

#include <optional>
#include <string>
#include <vector>

#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::label {

/// Properties of an object that are the same in every scene.
struct ObjectShape {
  std::string name;
  std::string class_text;
  std::string class_name;
  std::string id;
  int class_id = 0;
  int instance = 0;                               ///< its index among the objects, from 1
  std::vector<Eigen::Vector3d> keypoints_O;       ///< [m]
  std::vector<Eigen::Vector3d> bounding_shape_O;  ///< [m]
  Cuboid cuboid_O;
};

/// All of an object's labels that follow from its pose alone: no masks, and nothing about
/// occlusion.
/// @param X_GO  nothing if it is not in the scene
[[nodiscard]] SceneObject labelObject(const ObjectShape& shape, const std::optional<Pose>& X_GO,
                                      const Pose& X_GC, const CameraModel& camera);

}  // namespace synthetic_dataset::label
