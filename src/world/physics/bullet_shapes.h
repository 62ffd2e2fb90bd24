#pragma once

/// Collision geometry as Bullet takes it. Contacts lie where the shapes are drawn: what Bullet adds
/// around a shape to find contacts early is taken off the shape before.

#include <memory>

#include <Eigen/Core>

#include "synthetic_dataset/pose.h"
#include "world/description.h"

class btCollisionShape;
class btStridingMeshInterface;

namespace synthetic_dataset::world {

/// A shape, and what it points at.
struct BulletShape {
  BulletShape();
  BulletShape(BulletShape&&) noexcept;
  BulletShape& operator=(BulletShape&&) noexcept;
  ~BulletShape();

  std::shared_ptr<const Mesh> mesh;
  std::unique_ptr<btStridingMeshInterface> triangles;
  std::unique_ptr<btCollisionShape> shape;  ///< none where the geometry is empty
};

/// A part of a body that moves: convex, and where in the body's frame B it lies.
struct ConvexPart {
  BulletShape shape;
  Pose X_BP = Pose::Identity();
};

/// A shape for a body that never moves: planes are half spaces, meshes their very triangles.
/// @throws Error where a size is not above 0
[[nodiscard]] BulletShape makeFixedShape(const Shape& shape);

/// A shape for a body that moves. A mesh becomes its convex hull (of at most 256 points), laid out
/// in B's frame so that X_BP is the identity; a plane, which cannot move, becomes nothing.
/// @param X_BC  of the shape's own frame
/// @throws Error where a size is not above 0
[[nodiscard]] ConvexPart makeConvexPart(const Shape& shape, const Pose& X_BC);

/// The very triangles of a mesh, for contacts and rays.
[[nodiscard]] BulletShape makeTriangles(std::shared_ptr<const Mesh> mesh);

}  // namespace synthetic_dataset::world
