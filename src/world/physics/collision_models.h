#pragma once

/// The collision geometry of whole models: of those that stand still and of those that move.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "synthetic_dataset/pose.h"
#include "world/description.h"
#include "world/physics/bullet_shapes.h"

class btCompoundShape;

namespace synthetic_dataset::world {

/// How a surface rubs and bounces. Where two meet, the smaller value of each counts, as in Gazebo.
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

/// The collisions of a model that moves as one piece, in the frame B of its body.
struct MovingCollisions {
  MovingCollisions();
  MovingCollisions(MovingCollisions&&) noexcept;
  MovingCollisions& operator=(MovingCollisions&&) noexcept;
  ~MovingCollisions();

  /// All parts as one shape, or nothing where there is no part.
  [[nodiscard]] btCollisionShape* whole() const;

  std::vector<ConvexPart> parts;
  std::vector<ContactSurface> surfaces;  ///< one a part
  std::unique_ptr<btCompoundShape> compound;
  std::vector<std::string> notes;  ///< what was left out
};

/// @throws ErrorList naming the model and the collision
[[nodiscard]] std::vector<FixedCollision> fixedCollisions(const Model& model);

/// How far down the collisions reach, along a direction of unit length; nothing without any. A
/// plane reaches to where its origin is.
[[nodiscard]] std::optional<double> deepestPoint(const std::vector<FixedCollision>& collisions,
                                                 const Eigen::Vector3d& down);

/// @throws ErrorList naming the model and the collision
[[nodiscard]] MovingCollisions movingCollisions(const Model& model, const Pose& X_MB);

/// A dynamic model as one rigid body, all its links held together. Its frame B lies at the centre
/// of mass, along the principal axes.
struct PropModel {
  std::string name;
  Pose X_MB = Pose::Identity();
  double mass = 0.0;                                    ///< [kg]
  Eigen::Vector3d moments_B = Eigen::Vector3d::Zero();  ///< [kg m^2]
  double gravity_share = 1.0;                           ///< of its mass that has weight
  MovingCollisions collisions;
};

/// Whether a dynamic model can be simulated: one without any collision that can move stays put.
[[nodiscard]] bool canMove(const Model& model);

/// @param model  one that canMove
/// @throws ErrorList naming the model and what is wrong with its masses or collisions
[[nodiscard]] PropModel makeProp(const Model& model);

}  // namespace synthetic_dataset::world
