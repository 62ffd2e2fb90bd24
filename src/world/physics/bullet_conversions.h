#pragma once

/// Conversions between Eigen's double and Bullet's btScalar, which is float or double depending on
/// how the library was built.

#include <Eigen/Geometry>

#include <LinearMath/btTransform.h>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::world {

[[nodiscard]] inline btVector3 toBullet(const Eigen::Vector3d& vector) {
  return {static_cast<btScalar>(vector.x()), static_cast<btScalar>(vector.y()),
          static_cast<btScalar>(vector.z())};
}

[[nodiscard]] inline btTransform toBullet(const Pose& X_AB) {
  const Eigen::Quaterniond q(X_AB.linear());
  return btTransform(btQuaternion(static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()),
                                  static_cast<btScalar>(q.z()), static_cast<btScalar>(q.w())),
                     toBullet(Eigen::Vector3d(X_AB.translation())));
}

[[nodiscard]] inline Eigen::Vector3d fromBullet(const btVector3& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

[[nodiscard]] inline Pose fromBullet(const btTransform& X_AB) {
  const btQuaternion q = X_AB.getRotation();
  return makePose(fromBullet(X_AB.getOrigin()), Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()));
}

}  // namespace synthetic_dataset::world
