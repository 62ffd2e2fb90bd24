#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/pose.h"
#include "world/world.h"

namespace synthetic_dataset::world {

/// The first hit of a ray.
struct RayHit {
  std::size_t link = 0;      ///< index into the given links
  double distance = 0.0;     ///< from the ray's origin [m]
  Eigen::Vector3d normal_W;  ///< of the triangle, unit length, towards the ray's origin
};

/// Casts rays against the triangles of the links' visuals: finds what a camera would see without
/// rendering anything. Triangles are hit from both sides.
///
/// Bullet finds the triangles near the ray; whether it passes through them, and where, is computed
/// in double precision.
class RayCaster {
 public:
  /// @param links  their Link objects have to outlive this
  /// @param X_WL  of each link
  RayCaster(const std::vector<LinkInstance>& links, const std::vector<Pose>& X_WL);
  ~RayCaster();
  RayCaster(RayCaster&&) noexcept;
  RayCaster& operator=(RayCaster&&) noexcept;

  /// Moves the links; X_WL of each, in the same order.
  void setLinkPoses(const std::vector<Pose>& X_WL);

  /// The nearest triangle within `range` [m] of the origin p_W, in the given direction (of any
  /// length above 0).
  [[nodiscard]] std::optional<RayHit> cast(const Eigen::Vector3d& p_W,
                                           const Eigen::Vector3d& direction_W, double range) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::world
