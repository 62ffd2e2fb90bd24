#include "world/mesh/mesh_normals.h"

#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

namespace synthetic_dataset::world {
namespace {

constexpr float kShortest = 1e-12F;

bool isUsable(const Eigen::Vector3f& normal) {
  return normal.allFinite() && normal.norm() > kShortest;
}

std::vector<Eigen::Vector3f> meanFaceNormals(const Mesh& mesh) {
  std::vector<Eigen::Vector3d> sums(mesh.positions.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Eigen::Vector3d a = mesh.positions[mesh.indices[i]].cast<double>();
    const Eigen::Vector3d b = mesh.positions[mesh.indices[i + 1]].cast<double>();
    const Eigen::Vector3d c = mesh.positions[mesh.indices[i + 2]].cast<double>();
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    for (std::size_t corner = 0; corner < 3; ++corner) sums[mesh.indices[i + corner]] += normal;
  }
  std::vector<Eigen::Vector3f> normals;
  normals.reserve(sums.size());
  for (const Eigen::Vector3d& sum : sums) {
    const double length = sum.norm();
    // A vertex of only degenerate triangles is not seen; its normal is never used.
    const Eigen::Vector3d unit =
        length > 0.0 ? Eigen::Vector3d(sum / length) : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
    normals.push_back(unit.cast<float>());
  }
  return normals;
}

}  // namespace

void completeNormals(Mesh& mesh) {
  std::vector<Eigen::Vector3f> means;
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    if (isUsable(mesh.normals[i])) {
      mesh.normals[i].normalize();
      continue;
    }
    if (means.empty()) means = meanFaceNormals(mesh);
    mesh.normals[i] = means[i];
  }
}

}  // namespace synthetic_dataset::world
