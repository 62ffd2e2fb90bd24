#pragma once

#include <vector>

#include <Eigen/Core>

#include "world/description.h"

namespace synthetic_dataset::render {

/// A convex body around a mesh, tighter than a box, that has few corners.
struct BoundingHull {
  std::vector<Eigen::Vector3d> corners;              ///< the body is their convex hull
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of a ball inside the body
  double radius = 0.0;                               ///< [m] of the ball; 0 if there is none

  /// The corners of a body that contains all points that are at most `margin` [m] from this one.
  [[nodiscard]] std::vector<Eigen::Vector3d> cornersWith(double margin) const;
};

/// Bounds a mesh by its extent in 26 directions: along the axes, the diagonals of the planes of two
/// axes, and the diagonals of space (a discrete oriented polytope; Klosowski et al. 1998,
/// "Efficient Collision Detection Using Bounding Volume Hierarchies of k-DOPs").
/// @return a hull without corners for a mesh without vertices
[[nodiscard]] BoundingHull boundingHullOf(const world::Mesh& mesh);

}  // namespace synthetic_dataset::render
