#include "world/shape/shape_cache.h"

#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::world {
namespace {

std::shared_ptr<const Mesh> make(ShapeKind kind, const Eigen::Vector3d& size) {
  switch (kind) {
    case ShapeKind::kSphere:
      return sphereMesh(size.x());
    case ShapeKind::kEllipsoid:
      return ellipsoidMesh(size);
    case ShapeKind::kCylinder:
      return cylinderMesh(size.x(), size.y());
    case ShapeKind::kCapsule:
      return capsuleMesh(size.x(), size.y());
    case ShapeKind::kBox:
      break;
  }
  return boxMesh(size);
}

}  // namespace

std::shared_ptr<const Mesh> ShapeCache::mesh(ShapeKind kind, const Eigen::Vector3d& size) {
  auto& mesh = meshes_[{kind, size.x(), size.y(), size.z()}];
  if (!mesh) mesh = make(kind, size);
  return mesh;
}

}  // namespace synthetic_dataset::world
