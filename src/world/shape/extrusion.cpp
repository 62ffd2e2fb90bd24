#include "world/shape/extrusion.h"

#include <cstdint>

namespace synthetic_dataset::world {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2f;
using Eigen::Vector3f;

Vector3f at(const Vector2d& point, double height) {
  return Eigen::Vector3d(point.x(), point.y(), height).cast<float>();
}

std::uint32_t add(Mesh& mesh, const Vector3f& position, const Vector3f& normal,
                  const Vector2f& texture_coordinate) {
  mesh.positions.push_back(position);
  mesh.normals.push_back(normal);
  mesh.texture_coordinates.push_back(texture_coordinate);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

void addCap(Mesh& mesh, const Triangulation& filled, double height, bool top) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Outline& outline : filled.outlines) {
    for (const Vector2d& point : outline) {
      const Vector3f position = at(point, height);
      add(mesh, position, {0, 0, top ? 1.0F : -1.0F}, {position.x(), -position.y()});
    }
  }
  for (const auto& triangle : filled.triangles) {
    for (const std::size_t corner : {0, 1, 2}) {
      const std::size_t point = triangle[top ? corner : 2 - corner];
      mesh.indices.push_back(first + static_cast<std::uint32_t>(point));
    }
  }
}

/// The wall along an outline with the filled area on its left.
void addWall(Mesh& mesh, const Outline& outline, double height) {
  double passed = 0.0;
  const auto top = static_cast<float>(height);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d& from = outline[i];
    const Vector2d& to = outline[(i + 1) % outline.size()];
    const Vector2d along = (to - from).normalized();
    const Vector3f outwards = at({along.y(), -along.x()}, 0.0);
    const auto u_from = static_cast<float>(passed);
    passed += (to - from).norm();
    const auto u_to = static_cast<float>(passed);
    const std::uint32_t first = add(mesh, at(from, 0.0), outwards, {u_from, top});
    add(mesh, at(to, 0.0), outwards, {u_to, top});
    add(mesh, at(to, height), outwards, {u_to, 0.0F});
    add(mesh, at(from, height), outwards, {u_from, 0.0F});
    for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) {
      mesh.indices.push_back(first + corner);
    }
  }
}

}  // namespace

std::shared_ptr<const Mesh> extrudedMesh(const Extrusion& extrusion) {
  const Triangulation filled = triangulate(extrusion.outlines);
  auto mesh = std::make_shared<Mesh>();
  addCap(*mesh, filled, 0.0, false);
  addCap(*mesh, filled, extrusion.height, true);
  for (const Outline& outline : filled.outlines) addWall(*mesh, outline, extrusion.height);
  return mesh;
}

}  // namespace synthetic_dataset::world
