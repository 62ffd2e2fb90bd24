#pragma once

#include <chrono>

#include <Eigen/Geometry>

namespace synthetic_dataset {
inline namespace v2 {

/// A rigid transform. `X_AB` is the pose of frame B in frame A: `p_A = X_AB * p_B`; metres.
///
/// Unaligned on purpose: Eigen's aligned types change a struct's layout with the compiler's flags,
/// and this one crosses the boundary between the core and plugins built elsewhere.
using Pose = Eigen::Transform<double, 3, Eigen::Isometry, Eigen::DontAlign>;

/// Time since the epoch of the recording's clock (Unix or simulation time), whole nanoseconds.
using Stamp = std::chrono::nanoseconds;

/// A length of time, whole nanoseconds.
using Duration = std::chrono::nanoseconds;

/// Seconds as a floating-point number, for calculations that need one. Times are compared and added
/// in nanoseconds.
[[nodiscard]] inline double toSeconds(Duration duration) {
  return std::chrono::duration<double>(duration).count();
}

/// @param position  p_AB [m]
/// @param orientation  of B in A; need not be normalised
[[nodiscard]] inline Pose makePose(const Eigen::Vector3d& position,
                                   const Eigen::Quaterniond& orientation) {
  Pose X_AB = Pose::Identity();
  X_AB.linear() = orientation.normalized().toRotationMatrix();
  X_AB.translation() = position;
  return X_AB;
}

}  // namespace v2
}  // namespace synthetic_dataset
