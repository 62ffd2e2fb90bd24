#pragma once

/// Mass, centre of mass and moments of inertia, in any frame F.

#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/pose.h"
#include "world/description.h"

namespace synthetic_dataset::world {

struct MassProperties {
  double mass = 0.0;                                   ///< [kg]
  Eigen::Vector3d centre_F = Eigen::Vector3d::Zero();  ///< of mass [m]
  /// About the centre of mass, along F's axes [kg m^2].
  Eigen::Matrix3d moments_F = Eigen::Matrix3d::Zero();
};

/// The same body expressed in frame A, in which its own frame B has the pose X_AB.
[[nodiscard]] MassProperties seenFrom(const Pose& X_AB, const MassProperties& body_B);

/// Several bodies joined rigidly, by the parallel axis theorem.
[[nodiscard]] MassProperties combined(const std::vector<MassProperties>& bodies_F);

/// A solid of density 1 kg/m^3; a mesh counts as its convex hull, and an infinite plane has no
/// mass.
[[nodiscard]] MassProperties solid(const Shape& shape);

/// A link in its own frame: its inertia or, if the file gives none, its collision shapes as one
/// solid of 1 kg. All zero without either.
[[nodiscard]] MassProperties massOf(const Link& link);

/// All links of a model, in the model's frame.
[[nodiscard]] MassProperties massOf(const Model& model);

}  // namespace synthetic_dataset::world
