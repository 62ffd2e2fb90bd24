#pragma once

#include <map>
#include <memory>
#include <tuple>

#include <Eigen/Core>

#include "world/description.h"

namespace synthetic_dataset::world {

enum class ShapeKind { kBox, kSphere, kEllipsoid, kCylinder, kCapsule };

/// Shares the meshes of equal shapes.
class ShapeCache {
 public:
  /// @param size  box: lengths; sphere: radius; ellipsoid: radii; cylinder, capsule: radius, length
  ///     [m]; unused numbers 0
  [[nodiscard]] std::shared_ptr<const Mesh> mesh(ShapeKind kind, const Eigen::Vector3d& size);

 private:
  std::map<std::tuple<ShapeKind, double, double, double>, std::shared_ptr<const Mesh>> meshes_;
};

}  // namespace synthetic_dataset::world
