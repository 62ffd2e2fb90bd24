#pragma once

/// The collision geometry of whole models, static and moving.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "synthetic_dataset/pose.h"
#include "world/description.h"
#include "world/physics/bullet_shapes.h"

class btCompoundShape;

namespace synthetic_dataset::world {

/// Friction and restitution of a surface. When two surfaces touch, the smaller value of each
/// applies, as in Gazebo.
struct ContactSurface {
  double friction = 1.0;
  double restitution = 0.0;
};

/// One collision of a static model.
struct FixedCollision {
  std::string model;
  Pose X_WC = Pose::Identity();
  BulletShape shape;
  ContactSurface surface;
};

/// The collisions of a model that moves as one rigid body, in the body's frame B.
struct MovingCollisions {
  MovingCollisions();
  MovingCollisions(MovingCollisions&&) noexcept;
  MovingCollisions& operator=(MovingCollisions&&) noexcept;
  ~MovingCollisions();

  /// All parts as one shape; null if there are no parts.
  [[nodiscard]] btCollisionShape* whole() const;

  std::vector<ConvexPart> parts;
  std::vector<ContactSurface> surfaces;  ///< one per part
  std::unique_ptr<btCompoundShape> compound;
  std::vector<std::string> notes;  ///< what was left out
};

/// @throws ErrorList naming the model and the collision
[[nodiscard]] std::vector<FixedCollision> fixedCollisions(const Model& model);

/// How far the collisions reach along `down`, a unit vector [m]; nothing without collisions. For a
/// plane, its origin counts.
[[nodiscard]] std::optional<double> deepestPoint(const std::vector<FixedCollision>& collisions,
                                                 const Eigen::Vector3d& down);

/// @throws ErrorList naming the model and the collision
[[nodiscard]] MovingCollisions movingCollisions(const Model& model, const Pose& X_MB);

/// A dynamic model as one rigid body. Its frame B is at the centre of mass, along the principal
/// axes.
struct PropModel {
  std::string name;
  Pose X_MB = Pose::Identity();
  double mass = 0.0;                                    ///< [kg]
  Eigen::Vector3d moments_B = Eigen::Vector3d::Zero();  ///< [kg m^2]
  double gravity_share = 1.0;  ///< share of its mass that is subject to gravity
  MovingCollisions collisions;
};

/// Whether a dynamic model can be simulated: one without a collision that can move stays put.
[[nodiscard]] bool canMove(const Model& model);

/// @param model  canMove() has to be true for it
/// @throws ErrorList naming the model and what is wrong with its masses or collisions
[[nodiscard]] PropModel makeProp(const Model& model);

}  // namespace synthetic_dataset::world
