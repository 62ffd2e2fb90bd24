#include "world/physics/bullet_shapes.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <btBulletCollisionCommon.h>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"
#include "world/physics/bullet_conversions.h"
#include "world/physics/convex_hull.h"

namespace synthetic_dataset::world {
namespace {

/// How far below the surface of a convex shape its core begins: contacts shallower than this are
/// found quickly and exactly, deeper ones by an iteration (EPA).
constexpr double kMargin = 1e-3;         // [m]
constexpr double kLargestMargin = 0.1;   // of a shape's smallest half size
constexpr int kMostHullPoints = 256;     // Bullet looks at all of them for every contact
constexpr int kMostQuantized = 1 << 20;  // triangles: Bullet's compressed tree has 21 bits for them

void requirePositive(double size, const char* name) {
  if (size > 0.0 && std::isfinite(size)) return;
  throw Error(std::string(name) + " is " + fixed(size, 6) + " m; it has to be above 0");
}

btScalar marginOf(double smallest_half_size) {
  return static_cast<btScalar>(std::min(kMargin, kLargestMargin * smallest_half_size));
}

std::unique_ptr<btCollisionShape> convex(const BoxShape& box) {
  for (int axis = 0; axis < 3; ++axis) requirePositive(box.size[axis], "a side of the box");
  auto shape = std::make_unique<btBoxShape>(toBullet(Eigen::Vector3d(0.5 * box.size)));
  shape->setMargin(marginOf(0.5 * box.size.minCoeff()));
  return shape;
}

std::unique_ptr<btCollisionShape> convex(const SphereShape& sphere) {
  requirePositive(sphere.radius, "the sphere's radius");
  return std::make_unique<btSphereShape>(static_cast<btScalar>(sphere.radius));
}

std::unique_ptr<btCollisionShape> convex(const CylinderShape& cylinder) {
  requirePositive(cylinder.radius, "the cylinder's radius");
  requirePositive(cylinder.length, "the cylinder's length");
  auto shape = std::make_unique<btCylinderShapeZ>(
      toBullet({cylinder.radius, cylinder.radius, 0.5 * cylinder.length}));
  shape->setMargin(marginOf(std::min(cylinder.radius, 0.5 * cylinder.length)));
  return shape;
}

std::unique_ptr<btCollisionShape> convex(const PlaneShape&) { return nullptr; }

std::unique_ptr<btCollisionShape> hullShape(const Mesh& mesh, const Pose& X_BC) {
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3f& position : mesh.positions) {
    points.push_back(X_BC * Eigen::Vector3d(position.cast<double>()));
  }
  const ConvexHull whole = convexHull(points);
  const ConvexHull inner = convexHull(supportPoints(whole.vertices, kMostHullPoints), kMargin);
  if (inner.vertices.empty()) return nullptr;
  auto shape = std::make_unique<btConvexHullShape>();
  for (const Eigen::Vector3d& vertex : inner.vertices) shape->addPoint(toBullet(vertex), false);
  // A flat hull has no room for an inset; without any margin Bullet would find its contacts late.
  shape->setMargin(static_cast<btScalar>(inner.inset > 0.0 ? inner.inset : kMargin));
  shape->recalcLocalAabb();
  return shape;
}

std::unique_ptr<btCollisionShape> plane(const PlaneShape& plane) {
  const double length = plane.normal.norm();
  requirePositive(length, "the length of the plane's normal");
  auto shape = std::make_unique<btStaticPlaneShape>(
      toBullet(Eigen::Vector3d(plane.normal / length)), btScalar(0));
  shape->setMargin(0);
  return shape;
}

}  // namespace

BulletShape::BulletShape() = default;
BulletShape::BulletShape(BulletShape&&) noexcept = default;
BulletShape& BulletShape::operator=(BulletShape&&) noexcept = default;
BulletShape::~BulletShape() = default;

BulletShape makeTriangles(std::shared_ptr<const Mesh> mesh) {
  BulletShape result;
  if (mesh == nullptr || mesh->indices.size() < 3) return result;
  btIndexedMesh view;
  view.m_numTriangles = static_cast<int>(mesh->indices.size() / 3);
  view.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(mesh->indices.data());
  view.m_triangleIndexStride = 3 * static_cast<int>(sizeof(std::uint32_t));
  view.m_numVertices = static_cast<int>(mesh->positions.size());
  view.m_vertexBase = reinterpret_cast<const unsigned char*>(mesh->positions.data());
  view.m_vertexStride = static_cast<int>(sizeof(Eigen::Vector3f));
  view.m_vertexType = PHY_FLOAT;
  auto triangles = std::make_unique<btTriangleIndexVertexArray>();
  triangles->addIndexedMesh(view, PHY_INTEGER);
  auto shape = std::make_unique<btBvhTriangleMeshShape>(triangles.get(),
                                                        view.m_numTriangles < kMostQuantized);
  shape->setMargin(0);
  result.mesh = std::move(mesh);
  result.triangles = std::move(triangles);
  result.shape = std::move(shape);
  return result;
}

BulletShape makeFixedShape(const Shape& shape) {
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) return makeTriangles(mesh->mesh);
  if (const auto* half_space = std::get_if<PlaneShape>(&shape)) {
    BulletShape result;
    result.shape = plane(*half_space);
    return result;
  }
  return makeConvexPart(shape, Pose::Identity()).shape;
}

ConvexPart makeConvexPart(const Shape& shape, const Pose& X_BC) {
  ConvexPart part;
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) {
    if (mesh->mesh != nullptr) part.shape.shape = hullShape(*mesh->mesh, X_BC);
    return part;
  }
  part.X_BP = X_BC;
  part.shape.shape = std::visit(
      [](const auto& each) -> std::unique_ptr<btCollisionShape> {
        if constexpr (std::is_same_v<std::decay_t<decltype(each)>, MeshShape>)
          return nullptr;
        else
          return convex(each);
      },
      shape);
  return part;
}

}  // namespace synthetic_dataset::world
