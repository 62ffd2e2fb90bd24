#pragma once

#include <optional>

#include <Eigen/Core>

#include "synthetic_dataset/distortion.h"

namespace synthetic_dataset::lens {

/// The largest angle from the axis at which the lens sees [rad]: as far as its distortion is
/// one-to-one and its cutoff angle allows.
[[nodiscard]] double largestAngle(const Distortion& distortion);

/// Projects a direction in the optical frame (of any length) to the plane z = 1: its pixel is
/// (fx x + cx, fy y + cy). Returns nullopt beyond the largest angle.
[[nodiscard]] std::optional<Eigen::Vector2d> distort(const Distortion& distortion,
                                                     double largest_angle,
                                                     const Eigen::Vector3d& direction);

/// The unit vector that distort() maps to this place; nullopt if there is none.
[[nodiscard]] std::optional<Eigen::Vector3d> undistort(const Distortion& distortion,
                                                       double largest_angle,
                                                       const Eigen::Vector2d& place);

}  // namespace synthetic_dataset::lens
