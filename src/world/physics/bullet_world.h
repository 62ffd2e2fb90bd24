#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include <btBulletDynamicsCommon.h>

#include "synthetic_dataset/pose.h"
#include "world/physics/collision_models.h"

namespace synthetic_dataset::world {

/// A body and its contact surfaces, one for each part of its shape.
struct BulletBody {
  std::vector<ContactSurface> surfaces;
  std::unique_ptr<btRigidBody> body;
};

/// Bullet's dynamics, set up so that the same calls give the same bits on any processor, and so
/// that contacts neither creep nor sink.
///
/// Two things differ from btDiscreteDynamicsWorld: kinematic bodies have the velocity that they are
/// given, not one derived from their previous pose; and a contact uses the surfaces of the parts
/// that touch, with the smaller friction and the smaller restitution of the two.
class BulletWorld {
 public:
  /// @param gravity  [m/s^2]
  /// @param origin_W  origin of Bullet's coordinates: single precision suffices for a kilometre or
  ///     so, and maps in UTM coordinates are farther from W's origin
  BulletWorld(const Eigen::Vector3d& gravity, const Eigen::Vector3d& origin_W);
  ~BulletWorld();
  BulletWorld(const BulletWorld&) = delete;
  BulletWorld& operator=(const BulletWorld&) = delete;

  /// Adds a body to the world, which keeps it for its own lifetime.
  /// @param surfaces  one for each part of the body's shape
  /// @param flags  of btCollisionObject::CollisionFlags
  btRigidBody& add(const btRigidBody::btRigidBodyConstructionInfo& info,
                   std::vector<ContactSurface> surfaces, int flags = 0);

  /// Places a kinematic body, or takes it away: nothing touches it until it is placed again.
  void put(btRigidBody& body, const std::optional<Pose>& X_WB);

  /// @param step  [s]
  void step(double step);

  [[nodiscard]] btTransform toBulletWorld(const Pose& X_WB) const;
  [[nodiscard]] Pose fromBulletWorld(const btTransform& transform) const;

 private:
  Eigen::Vector3d origin_W_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  std::vector<std::unique_ptr<BulletBody>> bodies_;
  std::unique_ptr<btDiscreteDynamicsWorld> world_;  ///< refers to all members above
};

}  // namespace synthetic_dataset::world
