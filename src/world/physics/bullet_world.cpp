#include "world/physics/bullet_world.h"

#include <algorithm>
#include <utility>

#include "world/physics/bullet_conversions.h"

namespace synthetic_dataset::world {
namespace {

constexpr int kSolverIterations = 30;  // Bullet's 10 let stacks sink and creep

/// Rolling resistance: how far ahead of its axis a rolling body is supported [m], about that of a
/// rubber ball on a floor. Without it, round props would roll for ever and never sleep.
constexpr double kRollingResistance = 5e-4;

const ContactSurface& surfaceOf(const btCollisionObject& object, int part) {
  const auto& surfaces = static_cast<const BulletBody*>(object.getUserPointer())->surfaces;
  const bool known = part >= 0 && static_cast<std::size_t>(part) < surfaces.size();
  return surfaces[known ? static_cast<std::size_t>(part) : 0];
}

/// Applies the smaller friction and the smaller restitution of the two parts in contact.
void setSurfaces(btPersistentManifold& contacts) {
  for (int i = 0; i < contacts.getNumContacts(); ++i) {
    btManifoldPoint& point = contacts.getContactPoint(i);
    const ContactSurface& a = surfaceOf(*contacts.getBody0(), point.m_index0);
    const ContactSurface& b = surfaceOf(*contacts.getBody1(), point.m_index1);
    const double friction = std::min(a.friction, b.friction);
    const double rolling = friction > 0.0 ? kRollingResistance : 0.0;
    point.m_combinedFriction = static_cast<btScalar>(friction);
    point.m_combinedRestitution = static_cast<btScalar>(std::min(a.restitution, b.restitution));
    point.m_combinedRollingFriction = static_cast<btScalar>(rolling);
    point.m_combinedSpinningFriction = static_cast<btScalar>(rolling);
  }
}

/// Implements the two differences from btDiscreteDynamicsWorld that BulletWorld describes.
class SteppedWorld final : public btDiscreteDynamicsWorld {
 public:
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

 protected:
  void saveKinematicState(btScalar) override {}

 public:
  void solveConstraints(btContactSolverInfo& info) override {
    for (int i = 0; i < getDispatcher()->getNumManifolds(); ++i) {
      setSurfaces(*getDispatcher()->getManifoldByIndexInternal(i));
    }
    btDiscreteDynamicsWorld::solveConstraints(info);
  }
};

}  // namespace

BulletWorld::BulletWorld(const Eigen::Vector3d& gravity, const Eigen::Vector3d& origin_W)
    : origin_W_(origin_W),
      world_(
          std::make_unique<SteppedWorld>(&dispatcher_, &broadphase_, &solver_, &configuration_)) {
  world_->setGravity(toBullet(gravity));
  world_->setForceUpdateAllAabbs(false);
  world_->getDispatchInfo().m_deterministicOverlappingPairs = true;
  btContactSolverInfo& solver = world_->getSolverInfo();
  solver.m_numIterations = kSolverIterations;
  solver.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  // The results of Bullet's SIMD code differ between processors in the last bits.
  solver.m_solverMode &= ~SOLVER_SIMD;
  // Overlaps are resolved without making the bodies faster.
  solver.m_splitImpulse = 1;
  solver.m_splitImpulsePenetrationThreshold = 0;
}

BulletWorld::~BulletWorld() = default;

btRigidBody& BulletWorld::add(const btRigidBody::btRigidBodyConstructionInfo& info,
                              std::vector<ContactSurface> surfaces, int flags) {
  auto added = std::make_unique<BulletBody>();
  added->surfaces = std::move(surfaces);
  added->body = std::make_unique<btRigidBody>(info);
  added->body->setUserPointer(added.get());
  added->body->setCollisionFlags(added->body->getCollisionFlags() | flags);
  world_->addRigidBody(added->body.get());
  bodies_.push_back(std::move(added));
  return *bodies_.back()->body;
}

void BulletWorld::put(btRigidBody& body, const std::optional<Pose>& X_WB) {
  // Taking a body out of Bullet's world and putting it back would change the order of all bodies,
  // and with it the last bits of the results. So it stays there, below everything else: props stop
  // after 10 km.
  static const Pose kOutOfReach = makePose({0, 0, -1e5}, Eigen::Quaterniond::Identity());
  body.setWorldTransform(toBulletWorld(X_WB.value_or(kOutOfReach)));
  body.setInterpolationWorldTransform(body.getWorldTransform());
  world_->updateSingleAabb(&body);
}

void BulletWorld::step(double step) {
  world_->stepSimulation(static_cast<btScalar>(step), 0);  // 0: exactly this one step
}

btTransform BulletWorld::toBulletWorld(const Pose& X_WB) const {
  Pose shifted = X_WB;
  shifted.translation() -= origin_W_;
  return toBullet(shifted);
}

Pose BulletWorld::fromBulletWorld(const btTransform& transform) const {
  Pose X_WB = fromBullet(transform);
  X_WB.translation() += origin_W_;
  return X_WB;
}

}  // namespace synthetic_dataset::world
