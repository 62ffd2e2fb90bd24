#pragma once

#include <vector>

#include <Eigen/Core>

namespace synthetic_dataset::world {

/// The largest distance between any two of the points; 0 for fewer than two.
///
/// Exact, and fast for many points: they are put into a tree of boxes, and only those pairs of
/// boxes are examined whose points can be farther apart than the farthest pair found so far (branch
/// and bound).
[[nodiscard]] double largestDistance(std::vector<Eigen::Vector3d> points);

}  // namespace synthetic_dataset::world
