#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/camera_model.h"

namespace synthetic_dataset::lens {

/// The box around the part of the points' convex hull that a lens with distortion shows.
/// @param points_C  for a lens with a near plane, the corners of the clipped hull
[[nodiscard]] std::optional<Box> curvedBounds(const CameraModel& camera,
                                              const std::vector<Eigen::Vector3d>& points_C);

}  // namespace synthetic_dataset::lens
