#include "support/box_world.h"

namespace synthetic_dataset::test {
namespace {

/// Adds one face: its outward normal and the directions of growing u and v on it.
void addFace(world::Mesh& mesh, const Eigen::Vector3d& half, const Eigen::Vector3d& normal,
             const Eigen::Vector3d& u_axis, const Eigen::Vector3d& v_axis) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const auto& [u, v] : {std::pair{0, 0}, {0, 1}, {1, 1}, {1, 0}}) {
    const Eigen::Vector3d corner = normal + (2 * u - 1) * u_axis + (2 * v - 1) * v_axis;
    mesh.positions.emplace_back(corner.cwiseProduct(half).cast<float>());
    mesh.normals.emplace_back(normal.cast<float>());
    mesh.texture_coordinates.emplace_back(static_cast<float>(u), static_cast<float>(v));
  }
  // u right and v down, seen from outside: 0 1 2 runs counter-clockwise.
  for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U})
    mesh.indices.push_back(first + corner);
}

}  // namespace

std::shared_ptr<const world::Mesh> boxMesh(const Eigen::Vector3d& size) {
  auto mesh = std::make_shared<world::Mesh>();
  const Eigen::Vector3d half = 0.5 * size;
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  addFace(*mesh, half, x, y, -z);
  addFace(*mesh, half, -x, -y, -z);
  addFace(*mesh, half, y, -x, -z);
  addFace(*mesh, half, -y, x, -z);
  addFace(*mesh, half, z, x, -y);
  addFace(*mesh, half, -z, -x, -y);
  return mesh;
}

std::vector<Eigen::Vector3d> boxCorners(const Eigen::Vector3d& size) {
  std::vector<Eigen::Vector3d> corners;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      for (const double z : {-0.5, 0.5}) {
        corners.emplace_back(x * size.x(), y * size.y(), z * size.z());
      }
    }
  }
  return corners;
}

void Stage::addBox(const Eigen::Vector3d& size, const Pose& X_WL, int object,
                   const world::Material& material) {
  addMesh(boxMesh(size), X_WL, object, material);
}

void Stage::addMesh(const std::shared_ptr<const world::Mesh>& mesh, const Pose& X_WL, int object,
                    const world::Material& material) {
  auto link = std::make_unique<world::Link>();
  world::Visual visual;
  visual.surfaces.push_back({mesh, material});
  link->visuals.push_back(visual);
  instances_.push_back(
      {link.get(), object < 0 ? world::Role::kStatic : world::Role::kObject, object});
  links_.push_back(std::move(link));
  poses_.push_back(X_WL);
}

}  // namespace synthetic_dataset::test
