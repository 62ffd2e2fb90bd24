#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace synthetic_dataset::world {

/// The convex hull of some points.
struct ConvexHull {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;  ///< all with the same winding
  double inset = 0.0;  ///< how far its faces lie inside those of the points' hull [m]
};

/// @param inset  distance by which every face is moved inwards [m]; less if the hull is too thin
[[nodiscard]] ConvexHull convexHull(const std::vector<Eigen::Vector3d>& points, double inset = 0.0);

/// At most `count` of the points: those that lie farthest out in directions spread evenly over the
/// sphere; their hull is nearly that of all points. If there are no more than `count`, they are
/// returned as they are.
[[nodiscard]] std::vector<Eigen::Vector3d> supportPoints(const std::vector<Eigen::Vector3d>& points,
                                                         int count);

}  // namespace synthetic_dataset::world
