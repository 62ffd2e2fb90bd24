#include "world/physics/overlap_finder.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include <Eigen/Geometry>

#include <btBulletCollisionCommon.h>

#include "world/physics/bullet_conversions.h"

namespace synthetic_dataset::world {
namespace {

/// A shape at its pose.
struct Placed {
  btCollisionShape* shape = nullptr;
  Pose X_WS = Pose::Identity();
  Eigen::AlignedBox3d bounds_W;
};

Eigen::AlignedBox3d boundsOf(const btCollisionShape& shape, const Pose& X_WS) {
  if (shape.getShapeType() == STATIC_PLANE_PROXYTYPE) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return {Eigen::Vector3d::Constant(-kInfinity), Eigen::Vector3d::Constant(kInfinity)};
  }
  btVector3 lowest;
  btVector3 highest;
  shape.getAabb(btTransform::getIdentity(), lowest, highest);
  const Eigen::Vector3d centre = X_WS * Eigen::Vector3d(fromBullet((lowest + highest) / 2));
  const Eigen::Vector3d half = X_WS.linear().cwiseAbs() * fromBullet((highest - lowest) / 2);
  return {centre - half, centre + half};
}

Placed placed(btCollisionShape* shape, const Pose& X_WS) {
  return {shape, X_WS, boundsOf(*shape, X_WS)};
}

struct DeepestContact final : btCollisionWorld::ContactResultCallback {
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                           const btCollisionObjectWrapper*, int, int) override {
    depth = std::max(depth, -static_cast<double>(point.getDistance()));
    return 0;
  }
  double depth = 0.0;
};

}  // namespace

struct OverlapFinder::Impl {
  /// How deep one shape is in the other; 0 if they are apart.
  [[nodiscard]] double depth(const Placed& a, const Placed& b) const;

  [[nodiscard]] std::optional<std::string> obstacle(const Placed& body,
                                                    const std::vector<StandingBody>& others,
                                                    double tolerance) const;

  std::vector<Placed> fixed;
  std::vector<std::string> fixed_names;

  btDefaultCollisionConfiguration configuration;
  mutable btCollisionDispatcher dispatcher{&configuration};
  mutable btDbvtBroadphase broadphase;
  mutable btCollisionWorld world{&dispatcher, &broadphase, &configuration};
};

double OverlapFinder::Impl::depth(const Placed& a, const Placed& b) const {
  if (!a.bounds_W.intersects(b.bounds_W)) return 0.0;
  // Relative to a, so that numbers stay small however far from W's origin the two are.
  Pose X_AB = b.X_WS;
  X_AB.translation() -= a.X_WS.translation();
  Pose X_AA = a.X_WS;
  X_AA.translation().setZero();
  btCollisionObject object_a;
  object_a.setCollisionShape(a.shape);
  object_a.setWorldTransform(toBullet(X_AA));
  btCollisionObject object_b;
  object_b.setCollisionShape(b.shape);
  object_b.setWorldTransform(toBullet(X_AB));
  DeepestContact deepest;
  world.contactPairTest(&object_a, &object_b, deepest);
  return deepest.depth;
}

std::optional<std::string> OverlapFinder::Impl::obstacle(const Placed& body,
                                                         const std::vector<StandingBody>& others,
                                                         double tolerance) const {
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (depth(body, fixed[i]) > tolerance) return fixed_names[i];
  }
  for (const StandingBody& other : others) {
    btCollisionShape* shape = other.collisions->whole();
    if (shape != nullptr && depth(body, placed(shape, other.X_WB)) > tolerance) return other.name;
  }
  return std::nullopt;
}

OverlapFinder::OverlapFinder(const std::vector<FixedCollision>& fixed)
    : impl_(std::make_unique<Impl>()) {
  for (const FixedCollision& collision : fixed) {
    impl_->fixed.push_back(placed(collision.shape.shape.get(), collision.X_WC));
    impl_->fixed_names.push_back(collision.model);
  }
}

OverlapFinder::~OverlapFinder() = default;

std::vector<Interpenetration> OverlapFinder::find(const std::vector<StandingBody>& standing,
                                                  double tolerance) const {
  std::map<std::pair<std::string, std::string>, double> deepest;
  const auto note = [&](const std::string& first, const std::string& second, double depth) {
    if (depth <= tolerance) return;
    double& known = deepest[{first, second}];
    known = std::max(known, depth);
  };
  std::vector<std::pair<Placed, const std::string*>> bodies;
  for (const StandingBody& body : standing) {
    btCollisionShape* shape = body.collisions->whole();
    if (shape != nullptr) bodies.emplace_back(placed(shape, body.X_WB), &body.name);
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto& [body, name] = bodies[i];
    for (std::size_t k = i + 1; k < bodies.size(); ++k) {
      const auto& [other, other_name] = bodies[k];
      if (*name == *other_name) continue;  // of one object
      const auto [first, second] = std::minmax(*name, *other_name);
      note(first, second, impl_->depth(body, other));
    }
    for (std::size_t k = 0; k < impl_->fixed.size(); ++k) {
      note(*name, impl_->fixed_names[k], impl_->depth(body, impl_->fixed[k]));
    }
  }
  std::vector<Interpenetration> result;
  for (const auto& [names, depth] : deepest) result.push_back({names.first, names.second, depth});
  return result;
}

std::optional<std::string> OverlapFinder::obstacle(const StandingBody& body,
                                                   const std::vector<StandingBody>& others,
                                                   double tolerance) const {
  btCollisionShape* shape = body.collisions->whole();
  if (shape == nullptr) return std::nullopt;
  return impl_->obstacle(placed(shape, body.X_WB), others, tolerance);
}

std::optional<std::string> OverlapFinder::obstacle(const Eigen::Vector3d& centre_W, double radius,
                                                   const std::vector<StandingBody>& others) const {
  btSphereShape ball(static_cast<btScalar>(radius));
  Pose X_WS = Pose::Identity();
  X_WS.translation() = centre_W;
  return impl_->obstacle(placed(&ball, X_WS), others, 0.0);
}

}  // namespace synthetic_dataset::world
