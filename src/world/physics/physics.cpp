#include "world/physics/physics.h"

#include <algorithm>
#include <cmath>

#include <btBulletDynamicsCommon.h>

#include "synthetic_dataset/errors.h"
#include "world/physics/bullet_conversions.h"
#include "world/physics/bullet_world.h"

namespace synthetic_dataset::world {
namespace {

/// A prop slower than this for two seconds (Bullet's gDeactivationTime) goes to sleep.
constexpr double kSleepSpeed = 0.01;  // [m/s]
constexpr double kSleepSpin = 0.02;   // [rad/s]

/// A prop counts as moved when it is this far from where it was last seen: resting contacts jitter
/// by less, which nobody sees.
constexpr double kVisibleShift = 1e-5;  // [m]
constexpr double kVisibleTurn = 2e-5;   // [rad]

/// Props that have fallen off the world stop here; they would never come to rest.
constexpr double kLostDistance = 1e4;  // [m]

/// An object that is faster has jumped (in TF): it pushes nothing.
constexpr double kJumpSpeed = 100.0;  // [m/s]
constexpr double kJumpSpin = 100.0;   // [rad/s]
constexpr double kStillSpeed = 1e-6;  // [m/s], [rad/s]: noise of an object at rest

/// Radius, as a share of a prop's smallest half size, of the sphere that is swept along its path in
/// a step that moves it farther than that, so that small fast props do not pass through thin walls.
constexpr double kSweptShare = 0.5;

struct Velocity {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();
};

/// The constant velocity that leads from one pose to the other; zero for a jump.
Velocity velocityBetween(const Pose& X_WA, const Pose& X_WB, double seconds) {
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(X_WB.linear() * X_WA.linear().transpose()));
  Velocity velocity;
  velocity.linear = (X_WB.translation() - X_WA.translation()) / seconds;
  velocity.angular = turn.axis() * (turn.angle() / seconds);
  if (velocity.linear.norm() > kJumpSpeed || velocity.angular.norm() > kJumpSpin) return {};
  return velocity;
}

bool isFinite(const btVector3& vector) {
  return std::isfinite(vector.x()) && std::isfinite(vector.y()) && std::isfinite(vector.z());
}

void requireFinite(const btRigidBody& body, const std::string& name) {
  const btTransform& X = body.getWorldTransform();
  const bool finite = isFinite(X.getOrigin()) && isFinite(X.getBasis()[0]) &&
                      isFinite(X.getBasis()[1]) && isFinite(X.getBasis()[2]) &&
                      isFinite(body.getLinearVelocity()) && isFinite(body.getAngularVelocity());
  if (finite) return;
  throw Error("model '" + name +
              "': the simulation broke down, its pose is no longer finite; check the masses, "
              "moments of inertia and collision shapes of this model and of what it touches");
}

bool visiblyApart(const btTransform& a, const btTransform& b) {
  if ((a.getOrigin() - b.getOrigin()).length() > btScalar(kVisibleShift)) return true;
  for (int row = 0; row < 3; ++row) {
    const btVector3 difference = (a.getBasis()[row] - b.getBasis()[row]).absolute();
    if (difference[difference.maxAxis()] > btScalar(kVisibleTurn)) return true;
  }
  return false;
}

double smallestHalfSize(const btCollisionShape& shape) {
  btVector3 lowest;
  btVector3 highest;
  shape.getAabb(btTransform::getIdentity(), lowest, highest);
  const btVector3 half = (highest - lowest) / 2;
  return half[half.minAxis()];
}

}  // namespace

struct Physics::Impl {
  struct Prop {
    StartingProp given;
    btRigidBody* body = nullptr;
    btTransform start;       ///< X_WB in Bullet's coordinates
    btTransform seen;        ///< X_WB when it last moved visibly
    bool has_moved = false;  ///< since the start
    bool moves = false;      ///< in the last step
  };
  struct Object {                 // one body of an object
    btRigidBody* body = nullptr;  ///< null for an object without collisions
    std::optional<Pose> X_WO;
  };

  Impl(const Eigen::Vector3d& gravity, Duration step_in, const Eigen::Vector3d& origin_W)
      : step(toSeconds(step_in)), bullet(gravity, origin_W) {}

  void addFixed(const FixedCollision& collision);
  void addObject(const MovingCollisions& collisions);
  void addProp(const StartingProp& given);
  void setVelocity(const Object& object, const std::optional<Pose>& X_WO_next) const;

  double step;  ///< [s]
  std::vector<Object> objects;
  std::vector<Prop> props;
  BulletWorld bullet;  ///< refers to the props' shapes
};

void Physics::Impl::addFixed(const FixedCollision& collision) {
  btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, collision.shape.shape.get());
  info.m_startWorldTransform = bullet.toBulletWorld(collision.X_WC);
  bullet.add(info, {collision.surface});
}

void Physics::Impl::addObject(const MovingCollisions& collisions) {
  Object object;
  if (btCollisionShape* shape = collisions.whole()) {
    object.body = &bullet.add({0, nullptr, shape}, collisions.surfaces,
                              btCollisionObject::CF_KINEMATIC_OBJECT);
  }
  objects.push_back(object);
}

void Physics::Impl::addProp(const StartingProp& given) {
  const PropModel& model = *given.model;
  btCollisionShape* shape = model.collisions.whole();
  btRigidBody::btRigidBodyConstructionInfo info(static_cast<btScalar>(model.mass), nullptr, shape,
                                                toBullet(model.moments_B));
  info.m_startWorldTransform = bullet.toBulletWorld(given.X_WM * model.X_MB);
  info.m_linearSleepingThreshold = btScalar(kSleepSpeed);
  info.m_angularSleepingThreshold = btScalar(kSleepSpin);
  Prop prop;
  prop.body = &bullet.add(info, model.collisions.surfaces);
  if (model.gravity_share != 1.0) {
    prop.body->setGravity(prop.body->getGravity() * static_cast<btScalar>(model.gravity_share));
  }
  const auto swept = static_cast<btScalar>(kSweptShare * smallestHalfSize(*shape));
  prop.body->setCcdMotionThreshold(swept);
  prop.body->setCcdSweptSphereRadius(swept);
  prop.start = prop.seen = info.m_startWorldTransform;
  prop.given = given;
  props.push_back(prop);
}

void Physics::Impl::setVelocity(const Object& object, const std::optional<Pose>& X_WO_next) const {
  if (object.body == nullptr) return;
  Velocity velocity;
  bool still = !object.X_WO && !X_WO_next;
  if (object.X_WO && X_WO_next) {
    velocity = velocityBetween(*object.X_WO, *X_WO_next, step);
    still = velocity.linear.norm() < kStillSpeed && velocity.angular.norm() < kStillSpeed &&
            object.X_WO->isApprox(*X_WO_next);
  }
  object.body->setLinearVelocity(toBullet(velocity.linear));
  object.body->setAngularVelocity(toBullet(velocity.angular));
  // An object that is awake keeps every prop awake that it touches.
  object.body->forceActivationState(still ? ISLAND_SLEEPING : ACTIVE_TAG);
}

Physics::Physics(const Eigen::Vector3d& gravity, Duration step,
                 const std::vector<FixedCollision>& fixed,
                 const std::vector<const MovingCollisions*>& objects,
                 const std::vector<StartingProp>& props) {
  // Any place near the props will do; whole metres keep round numbers round.
  Eigen::Vector3d origin_W = Eigen::Vector3d::Zero();
  if (!props.empty()) origin_W = props.front().X_WM.translation().array().round();
  impl_ = std::make_unique<Impl>(gravity, step, origin_W);
  for (const FixedCollision& collision : fixed) impl_->addFixed(collision);
  for (const MovingCollisions* collisions : objects) impl_->addObject(*collisions);
  for (const StartingProp& prop : props) impl_->addProp(prop);
}

Physics::~Physics() = default;

void Physics::placeObjects(const std::vector<std::optional<Pose>>& X_WO) {
  for (std::size_t i = 0; i < impl_->objects.size(); ++i) {
    Impl::Object& object = impl_->objects[i];
    object.X_WO = X_WO[i];
    if (object.body != nullptr) impl_->bullet.put(*object.body, X_WO[i]);
  }
}

void Physics::step(const std::vector<std::optional<Pose>>& X_WO) {
  for (std::size_t i = 0; i < impl_->objects.size(); ++i) {
    impl_->setVelocity(impl_->objects[i], X_WO[i]);
  }
  impl_->bullet.step(impl_->step);
  placeObjects(X_WO);
  for (Impl::Prop& prop : impl_->props) {
    prop.moves = false;
    if (!prop.body->isActive()) continue;
    requireFinite(*prop.body, prop.given.model->name);
    const btTransform& X = prop.body->getWorldTransform();
    if (!visiblyApart(X, prop.seen)) continue;
    prop.seen = X;
    prop.has_moved = true;
    const double distance = fromBullet(X.getOrigin() - prop.start.getOrigin()).norm();
    prop.moves = distance < kLostDistance;
    if (!prop.moves) prop.body->forceActivationState(DISABLE_SIMULATION);
  }
}

Pose Physics::propPose(std::size_t index, Duration since) const {
  const Impl::Prop& prop = impl_->props[index];
  if (!prop.has_moved) return prop.given.X_WM;
  btTransform shown = prop.seen;
  if (prop.moves && since > Duration::zero()) {
    btTransformUtil::integrateTransform(prop.seen, prop.body->getLinearVelocity(),
                                        prop.body->getAngularVelocity(),
                                        static_cast<btScalar>(toSeconds(since)), shown);
  }
  return impl_->bullet.fromBulletWorld(shown) * prop.given.model->X_MB.inverse();
}

bool Physics::isAtRest(std::size_t prop) const {
  const btRigidBody& body = *impl_->props[prop].body;
  return !body.isActive() && body.getActivationState() != DISABLE_SIMULATION;
}

bool Physics::isAtRest() const {
  return std::none_of(impl_->props.begin(), impl_->props.end(),
                      [](const Impl::Prop& prop) { return prop.body->isActive(); });
}

}  // namespace synthetic_dataset::world
