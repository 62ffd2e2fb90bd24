#pragma once

#include <vector>

#include <Eigen/Core>

#include "world/description.h"

namespace synthetic_dataset::render {

/// A convex body around a mesh, closer to it than a box, that has few corners.
struct BoundingHull {
  std::vector<Eigen::Vector3d> corners;              ///< of which it is the convex hull
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of a ball within
  double radius = 0.0;                               ///< [m] of the ball; 0 where there is none

  /// The corners of a body around all places that are at most `margin` [m] away from this one.
  [[nodiscard]] std::vector<Eigen::Vector3d> cornersWith(double margin) const;
};

/// Bounds a mesh by how far it extends in 26 directions: along the axes, the
/// diagonals of their planes, and those of space (a discrete oriented polytope; Klosowski et al.
/// 1998, "Efficient Collision Detection Using Bounding Volume Hierarchies of k-DOPs").
/// @return without corners for a mesh without vertices
[[nodiscard]] BoundingHull boundingHullOf(const world::Mesh& mesh);

}  // namespace synthetic_dataset::render
