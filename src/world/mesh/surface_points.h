#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "world/description.h"

namespace synthetic_dataset::world {

/// A point that is fixed to a link.
struct SurfacePoint {
  std::size_t link = 0;  ///< index into the given links
  Eigen::Vector3d p_L = Eigen::Vector3d::Zero();
};

/// Points on the visuals of a model at rest, chosen by farthest point sampling (Peng et al. 2019,
/// "PVNet: Pixel-wise Voting Network for 6DoF Pose Estimation", section 3.1): the first is the one
/// farthest from the centre of the model's box, each further one the farthest from those before it.
/// The candidates are the triangles' corners and points spread over their area, so that round
/// shapes and large faces are covered too. The same links give the same points.
/// @param links  of the model
/// @param count  at least 1
/// @throws Error if the visuals have fewer distinct points
[[nodiscard]] std::vector<SurfacePoint> farthestPoints(const std::vector<const Link*>& links,
                                                       int count);

}  // namespace synthetic_dataset::world
