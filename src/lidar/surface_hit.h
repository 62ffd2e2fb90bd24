#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "lidar/ray_bodies.h"
#include "synthetic_dataset/cloud.h"

namespace synthetic_dataset::lidar {

/// The labels of a link's points.
struct LinkLabel {
  std::uint16_t instance = 0;
  std::uint16_t class_number = 0;
  std::uint16_t world_class = 0;
  std::uint16_t part = 0;
};

/// What a ray has hit.
struct SurfaceHit {
  RayHit hit;
  Eigen::Matrix3d R_WB = Eigen::Matrix3d::Identity();  ///< of the body
};

/// The surface's unit normal, on the side from which the ray comes.
/// @param surface  that was hit
/// @param direction_W  of the ray
[[nodiscard]] Eigen::Vector3d normalOf(const SurfaceHit& met, const RaySurface& surface,
                                       const Eigen::Vector3d& direction_W);

/// Gives a point the labels of the link that it lies on.
void setLabel(const LinkLabel& label, CloudPoint& point);

}  // namespace synthetic_dataset::lidar
