#pragma once

#include <string>
#include <vector>

#include "synthetic_dataset/pose.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

[[nodiscard]] inline Value numbersValue(const std::vector<double>& numbers) {
  return Value::List(numbers.begin(), numbers.end());
}

[[nodiscard]] inline Value namesValue(const std::vector<std::string>& names) {
  return Value::List(names.begin(), names.end());
}

[[nodiscard]] inline Value pointValue(const Eigen::Vector3d& point) {
  return numbersValue({point.x(), point.y(), point.z()});
}

/// [x, y, z, qx, qy, qz, qw], in the form used for poses in settings.
[[nodiscard]] inline Value poseValue(const Pose& X) {
  const Eigen::Vector3d p = X.translation();
  const Eigen::Quaterniond q(X.linear());
  return numbersValue({p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()});
}

}  // namespace synthetic_dataset::run
