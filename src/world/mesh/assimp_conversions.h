#pragma once

#include <Eigen/Geometry>

#include <assimp/matrix4x4.h>

namespace synthetic_dataset::world {

[[nodiscard]] inline Eigen::Affine3d affineOf(const aiMatrix4x4& matrix) {
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  for (unsigned row = 0; row < 3; ++row) {
    for (unsigned column = 0; column < 4; ++column) {
      result(row, column) = static_cast<double>(matrix[row][column]);
    }
  }
  return result;
}

}  // namespace synthetic_dataset::world
