#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "lidar/ray_bodies.h"
#include "synthetic_dataset/cloud.h"

namespace synthetic_dataset::lidar {

/// What the labels of a link's points are.
struct LinkLabel {
  std::uint16_t instance = 0;
  std::uint16_t class_number = 0;
  std::uint16_t world_class = 0;
  std::uint16_t part = 0;
};

/// What a ray has met.
struct MetSurface {
  RayHit hit;
  Eigen::Matrix3d R_WB = Eigen::Matrix3d::Identity();  ///< of the body
};

/// The surface's normal of length 1, on the side from which the ray comes.
/// @param surface  that was met
/// @param direction_W  of the ray
[[nodiscard]] Eigen::Vector3d normalOf(const MetSurface& met, const RaySurface& surface,
                                       const Eigen::Vector3d& direction_W);

/// Gives a point the labels of the link that it is of.
void setLabel(const LinkLabel& label, CloudPoint& point);

}  // namespace synthetic_dataset::lidar
