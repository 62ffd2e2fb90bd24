#pragma once

#include <random>

#include <Eigen/Geometry>

namespace synthetic_dataset::test {

/// Uniform over all orientations: a normalised quaternion of four normal numbers.
[[nodiscard]] inline Eigen::Quaterniond randomOrientation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Eigen::Vector4d q;
  for (int i = 0; i < 4; ++i) q[i] = normal(random);
  q.normalize();
  return {q[3], q[0], q[1], q[2]};
}

/// Uniform in a cube of half side `reach` around the origin.
[[nodiscard]] inline Eigen::Vector3d randomPoint(std::mt19937& random, double reach) {
  std::uniform_real_distribution<double> uniform(-reach, reach);
  Eigen::Vector3d point;
  for (int i = 0; i < 3; ++i) point[i] = uniform(random);
  return point;
}

}  // namespace synthetic_dataset::test
