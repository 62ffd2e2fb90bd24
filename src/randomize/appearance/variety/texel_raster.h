#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Core>

namespace synthetic_dataset::randomize {

/// Visits the texels whose centres are covered by a triangle.
/// @param corners  in texels: the first texel's centre is at (0.5, 0.5)
/// @param visit  called with column, row (of any sign) and the weights of the corners
template <class Visit>
void forEachTexel(const std::array<Eigen::Vector2d, 3>& corners, const Visit& visit) {
  const Eigen::Vector2d ab = corners[1] - corners[0];
  const Eigen::Vector2d ac = corners[2] - corners[0];
  const double doubled = ab.x() * ac.y() - ab.y() * ac.x();
  if (std::abs(doubled) < 1e-9) return;
  const Eigen::Vector2d low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
  const Eigen::Vector2d high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
  const int last_row = static_cast<int>(std::floor(high.y() - 0.5));
  const int last_column = static_cast<int>(std::floor(high.x() - 0.5));
  for (int row = static_cast<int>(std::ceil(low.y() - 0.5)); row <= last_row; ++row) {
    for (int column = static_cast<int>(std::ceil(low.x() - 0.5)); column <= last_column; ++column) {
      const Eigen::Vector2d p(column + 0.5 - corners[0].x(), row + 0.5 - corners[0].y());
      const double b = (p.x() * ac.y() - p.y() * ac.x()) / doubled;
      const double c = (ab.x() * p.y() - ab.y() * p.x()) / doubled;
      constexpr double kOn = -1e-9;
      if (b < kOn || c < kOn || b + c > 1.0 - kOn) continue;
      visit(column, row, Eigen::Vector3d(1.0 - b - c, b, c));
    }
  }
}

}  // namespace synthetic_dataset::randomize
