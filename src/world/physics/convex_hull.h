#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace synthetic_dataset::world {

/// The smallest convex solid around some points.
struct ConvexHull {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;  ///< all of the same winding
  double inset = 0.0;                         ///< how far its faces lie inside those of the points
};

/// @param inset  [m] moves every face inwards by as much, or by less where the hull is too thin
[[nodiscard]] ConvexHull convexHull(const std::vector<Eigen::Vector3d>& points, double inset = 0.0);

/// At most `count` of the points, those that stand out farthest in directions spread evenly over
/// the sphere: their hull is nearly that of all. Few points are given back as they are.
[[nodiscard]] std::vector<Eigen::Vector3d> supportPoints(const std::vector<Eigen::Vector3d>& points,
                                                         int count);

}  // namespace synthetic_dataset::world
