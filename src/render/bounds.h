#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Geometry>

namespace synthetic_dataset::render {

/// A box along the axes of its frame; empty until something is in it.
using Bounds = Eigen::AlignedBox3d;

/// Of bounds that are not empty.
[[nodiscard]] inline std::array<Eigen::Vector3d, 8> cornersOf(const Bounds& bounds) {
  std::array<Eigen::Vector3d, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = bounds.corner(static_cast<Bounds::CornerType>(i));
  }
  return corners;
}

}  // namespace synthetic_dataset::render
