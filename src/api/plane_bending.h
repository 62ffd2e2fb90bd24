#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "synthetic_dataset/distortion.h"

/// OpenCV's polynomials, which bend the picture on the plane z = 1:
/// https://docs.opencv.org/4.x/d9/d0c/group__calib3d.html
namespace synthetic_dataset::lens {

/// k1, k2, p1, p2, k3, k4, k5, k6, s1, s2, s3, s4, tau_x, tau_y.
using Bending = std::array<double, Distortion::kMostCoefficients>;

/// The distorted position of a point of the plane; nullopt if it is behind a tilted sensor.
[[nodiscard]] std::optional<Eigen::Vector2d> bend(const Bending& k, const Eigen::Vector2d& x);

/// Whether the bending is one-to-one at this distance from the axis.
///
/// A map is one-to-one on a disc where the symmetric part of its Jacobian is positive definite. The
/// radial part's eigenvalues are the factor and the radius's slope; those of the tangential part,
/// 2 (p x^T + x p^T + p.x I), are at least -6 |p| r; those of a thin prism, whose Jacobian is
/// a x^T, at least -|a| r. A tilt is a view of the plane, and itself one-to-one.
[[nodiscard]] bool isOneToOne(const Bending& k, double r);

/// The point that bend() maps to this place; nullopt if there is none.
/// @param end  the largest distance from the axis at which bend() is one-to-one; may be infinite
[[nodiscard]] std::optional<Eigen::Vector2d> unbend(const Bending& k, double end,
                                                    const Eigen::Vector2d& place);

}  // namespace synthetic_dataset::lens
