#pragma once

#include "synthetic_dataset/cuboid.h"
#include "synthetic_dataset/object_model.h"

namespace synthetic_dataset {

/// A model with the eight corners of a cuboid, in their order, and two of its triangles.
[[nodiscard]] inline ObjectModel cuboidModel(const Cuboid& cuboid) {
  ObjectModel model;
  for (const Eigen::Vector3d& corner : cuboid.corners()) {
    model.vertices.push_back({corner, (corner - cuboid.centre()).normalized(), {200, 100, 50}});
  }
  model.triangles = {{0, 1, 2}, {1, 3, 2}};
  model.diameter = cuboid.size().norm();
  return model;
}

}  // namespace synthetic_dataset
