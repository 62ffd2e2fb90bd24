#pragma once

#include <Eigen/Geometry>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::base {

/// A pose to be interpolated, as the position and the rotation of its frame.
struct Placement {
  Eigen::Vector3d position{0, 0, 0};
  Eigen::Quaternion<double, Eigen::DontAlign> turn{1, 0, 0, 0};

  Placement() = default;
  explicit Placement(const Pose& X_AB) : position(X_AB.translation()), turn(X_AB.linear()) {}

  [[nodiscard]] Pose pose() const { return makePose(position, Eigen::Quaterniond(turn)); }
};

/// Interpolates as tf2 does: positions along a line, rotations about one axis.
[[nodiscard]] inline Placement between(const Placement& a, const Placement& b, double share) {
  if (share <= 0.0) return a;
  if (share >= 1.0) return b;
  Placement result;
  result.position = a.position + share * (b.position - a.position);
  result.turn = a.turn.slerp(share, b.turn);
  return result;
}

}  // namespace synthetic_dataset::base
