#include "randomize/appearance/texture_tiling.h"

#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

namespace synthetic_dataset::randomize {

Eigen::Vector2d metresPerTexture(const world::Mesh& mesh) {
  constexpr double kNoArea = 1e-12;  // of a triangle in the texture
  Eigen::Vector2d sum(0, 0);
  double area_sum = 0.0;
  if (mesh.texture_coordinates.empty()) return sum;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const auto a = mesh.indices[i];
    const auto b = mesh.indices[i + 1];
    const auto c = mesh.indices[i + 2];
    const Eigen::Vector3d ab = (mesh.positions[b] - mesh.positions[a]).cast<double>();
    const Eigen::Vector3d ac = (mesh.positions[c] - mesh.positions[a]).cast<double>();
    Eigen::Matrix2d edges;  // in the texture, one per column
    edges.col(0) = (mesh.texture_coordinates[b] - mesh.texture_coordinates[a]).cast<double>();
    edges.col(1) = (mesh.texture_coordinates[c] - mesh.texture_coordinates[a]).cast<double>();
    const double determinant = edges.determinant();
    if (std::abs(determinant) < kNoArea) continue;
    Eigen::Matrix<double, 3, 2> along;
    along << ab, ac;
    const Eigen::Matrix<double, 3, 2> metres = along * edges.inverse();  // along u, along v
    const double area = 0.5 * ab.cross(ac).norm();
    sum += area * Eigen::Vector2d(metres.col(0).norm(), metres.col(1).norm());
    area_sum += area;
  }
  if (area_sum > 0.0) sum /= area_sum;
  return sum;
}

}  // namespace synthetic_dataset::randomize
