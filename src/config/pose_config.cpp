#include "config/pose_config.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "config/checked_values.h"
#include "config/distribution_config.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::config {

std::optional<Eigen::Vector3d> maybeVector(Parameters& group, const std::string& name,
                                           double farthest, const std::string& should) {
  const auto numbers = group.maybe<std::vector<double>>(name);
  if (!numbers) return std::nullopt;
  const bool is_near = std::all_of(numbers->begin(), numbers->end(),
                                   [&](double each) { return std::abs(each) <= farthest; });
  if (numbers->size() == 3 && is_near) {
    return Eigen::Vector3d((*numbers)[0], (*numbers)[1], (*numbers)[2]);
  }
  group.addError(name, "found " + group.required<Value>(name).text() + "; it should be " + should);
  return std::nullopt;
}

std::optional<Eigen::Vector3d> maybeAngles(Parameters& group) {
  return maybeVector(group, "rpy", 2.0 * kHalfTurn,
                     std::string("[roll, pitch, yaw], each at most a turn of 6.283") + kAngleUnit);
}

Pose readPose(Parameters& group, const std::string& name, const std::string& or_else) {
  const auto numbers = group.maybe<std::vector<double>>(name);
  if (!numbers) return Pose::Identity();
  const std::vector<double>& n = *numbers;
  if (n.size() != 7) {
    group.addError(name, "found " + std::to_string(n.size()) +
                             " numbers; it should be [x, y, z, qx, qy, qz, qw]" + or_else);
    return Pose::Identity();
  }
  const Eigen::Quaterniond orientation(n[6], n[3], n[4], n[5]);
  constexpr double kTolerance = 1e-2;  // accepts a rounded quaternion, but not a wrong one
  if (std::abs(orientation.norm() - 1.0) > kTolerance) {
    group.addError(name, "found a quaternion of length " + fixed(orientation.norm(), 4) +
                             "; qx, qy, qz, qw should have length 1");
    return Pose::Identity();
  }
  return makePose({n[0], n[1], n[2]}, orientation);
}

}  // namespace synthetic_dataset::config
