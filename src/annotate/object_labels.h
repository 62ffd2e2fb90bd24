#pragma once

#include <string>
#include <vector>

#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::annotate {

/// What is known of an object whatever the scene.
struct ObjectShape {
  std::string name;
  std::string class_name;
  std::string id;
  std::vector<Eigen::Vector3d> keypoints_O;       ///< [m]
  std::vector<Eigen::Vector3d> bounding_shape_O;  ///< [m]
};

/// All of an object's labels that follow from its pose alone: everything but the mask.
[[nodiscard]] SceneObject labelObject(const ObjectShape& shape, const Pose& X_GO, const Pose& X_GC,
                                      const CameraModel& camera);

}  // namespace synthetic_dataset::annotate
