#pragma once

#include <vector>

#include <Eigen/Geometry>

namespace synthetic_dataset::render {

/// An axis-aligned box; empty until something is added to it.
using Bounds = Eigen::AlignedBox3d;

/// The corners of bounds that are not empty.
[[nodiscard]] inline std::vector<Eigen::Vector3d> cornersOf(const Bounds& bounds) {
  constexpr int kCorners = 8;
  std::vector<Eigen::Vector3d> corners;
  corners.reserve(kCorners);
  for (int i = 0; i < kCorners; ++i) {
    corners.emplace_back(bounds.corner(static_cast<Bounds::CornerType>(i)));
  }
  return corners;
}

}  // namespace synthetic_dataset::render
