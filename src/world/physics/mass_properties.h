#pragma once

/// How heavy things are and how their mass is spread, in any frame F.

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

/// The same body seen from frame A, in which its own frame B lies at X_AB.
[[nodiscard]] MassProperties seenFrom(const Pose& X_AB, const MassProperties& body_B);

/// Several bodies held together, by the parallel axis theorem.
[[nodiscard]] MassProperties combined(const std::vector<MassProperties>& bodies_F);

/// A solid of density 1 kg/m^3: of a mesh its convex hull; an infinite plane has no mass.
[[nodiscard]] MassProperties solid(const Shape& shape);

/// A link in its own frame: its inertia, or, where the file gives none, its collision shapes as one
/// solid of 1 kg. Without either, nothing.
[[nodiscard]] MassProperties massOf(const Link& link);

/// All links of a model, in the model's frame.
[[nodiscard]] MassProperties massOf(const Model& model);

}  // namespace synthetic_dataset::world
