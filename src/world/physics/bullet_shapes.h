#pragma once

/// Collision geometry in the form used by Bullet. Contacts lie on the surfaces as drawn: the margin
/// that Bullet adds around a shape to find contacts early is subtracted from the shape first.

#include <memory>

#include <Eigen/Core>

#include "synthetic_dataset/pose.h"
#include "world/description.h"

class btCollisionShape;
class btStridingMeshInterface;

namespace synthetic_dataset::world {

/// A shape and the data that it points to.
struct BulletShape {
  BulletShape();
  BulletShape(BulletShape&&) noexcept;
  BulletShape& operator=(BulletShape&&) noexcept;
  ~BulletShape();

  std::shared_ptr<const Mesh> mesh;
  std::unique_ptr<btStridingMeshInterface> triangles;
  std::unique_ptr<btCollisionShape> shape;  ///< null if the geometry is empty
};

/// A convex part of a moving body, and its pose in the body's frame B.
struct ConvexPart {
  BulletShape shape;
  Pose X_BP = Pose::Identity();
};

/// A shape for a body that never moves: planes are half spaces, meshes keep their exact triangles.
/// @throws Error if a size is not above 0
[[nodiscard]] BulletShape makeFixedShape(const Shape& shape);

/// A shape for a body that moves. A mesh becomes its convex hull (of at most 256 points), laid out
/// in B's frame so that X_BP is the identity; a plane, which cannot move, gives no shape.
/// @param X_BC  pose of the shape's own frame
/// @throws Error if a size is not above 0
[[nodiscard]] ConvexPart makeConvexPart(const Shape& shape, const Pose& X_BC);

/// The exact triangles of a mesh, for contacts and rays.
[[nodiscard]] BulletShape makeTriangles(std::shared_ptr<const Mesh> mesh);

}  // namespace synthetic_dataset::world
