#include "world/physics/ray_caster.h"

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <btBulletCollisionCommon.h>

#include "world/physics/bullet_conversions.h"
#include "world/physics/bullet_shapes.h"

namespace synthetic_dataset::world {
namespace {

/// One mesh of one visual where it stands.
struct Target {
  std::size_t link = 0;
  Pose X_LV = Pose::Identity();
  Pose X_WV = Pose::Identity();
  const Mesh* mesh = nullptr;
  std::unique_ptr<btCollisionObject> object;
};

/// Bullet's nearest hit, and which triangle it was.
struct NearestTriangle final : btCollisionWorld::ClosestRayResultCallback {
  using ClosestRayResultCallback::ClosestRayResultCallback;
  btScalar addSingleResult(btCollisionWorld::LocalRayResult& result, bool in_world) override {
    if (result.m_localShapeInfo != nullptr) triangle = result.m_localShapeInfo->m_triangleIndex;
    return ClosestRayResultCallback::addSingleResult(result, in_world);
  }
  int triangle = -1;
};

std::array<Eigen::Vector3d, 3> cornersOf(const Target& target, int triangle) {
  std::array<Eigen::Vector3d, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t index = target.mesh->indices[3 * static_cast<std::size_t>(triangle) + i];
    corners[i] = target.X_WV * Eigen::Vector3d(target.mesh->positions[index].cast<double>());
  }
  return corners;
}

}  // namespace

struct RayCaster::Impl {
  void add(const Surface& surface, const Pose& X_LV, std::size_t link);

  std::map<const Mesh*, BulletShape> shapes;  ///< looked up only: the order does not matter
  std::vector<Target> targets;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btCollisionWorld world{&dispatcher, &broadphase, &configuration};  ///< refers to all above
};

void RayCaster::Impl::add(const Surface& surface, const Pose& X_LV, std::size_t link) {
  const auto [entry, is_new] = shapes.try_emplace(surface.mesh.get());
  if (is_new) entry->second = makeTriangles(surface.mesh);
  if (!entry->second.shape) return;
  Target target;
  target.link = link;
  target.X_LV = X_LV;
  target.mesh = surface.mesh.get();
  target.object = std::make_unique<btCollisionObject>();
  target.object->setCollisionShape(entry->second.shape.get());
  target.object->setUserIndex(static_cast<int>(targets.size()));
  world.addCollisionObject(target.object.get());
  targets.push_back(std::move(target));
}

RayCaster::RayCaster(const std::vector<LinkInstance>& links, const std::vector<Pose>& X_WL)
    : impl_(std::make_unique<Impl>()) {
  for (std::size_t i = 0; i < links.size(); ++i) {
    for (const Visual& visual : links[i].link->visuals) {
      for (const Surface& surface : visual.surfaces) impl_->add(surface, visual.X_LV, i);
    }
  }
  setLinkPoses(X_WL);
}

RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

void RayCaster::setLinkPoses(const std::vector<Pose>& X_WL) {
  for (Target& target : impl_->targets) {
    target.X_WV = X_WL[target.link] * target.X_LV;
    target.object->setWorldTransform(toBullet(target.X_WV));
    impl_->world.updateSingleAabb(target.object.get());
  }
}

std::optional<RayHit> RayCaster::cast(const Eigen::Vector3d& p_W,
                                      const Eigen::Vector3d& direction_W, double range) const {
  const Eigen::Vector3d direction = direction_W.normalized();
  const btVector3 from = toBullet(p_W);
  const btVector3 to = toBullet(Eigen::Vector3d(p_W + range * direction));
  NearestTriangle nearest(from, to);
  impl_->world.rayTest(from, to, nearest);
  if (!nearest.hasHit()) return std::nullopt;

  const auto index = static_cast<std::size_t>(nearest.m_collisionObject->getUserIndex());
  const Target& target = impl_->targets[index];
  const auto [a, b, c] = cornersOf(target, nearest.triangle);
  RayHit hit;
  hit.link = target.link;
  hit.normal_W = (b - a).cross(c - a).normalized();
  if (hit.normal_W.dot(direction) > 0.0) hit.normal_W = -hit.normal_W;
  hit.distance = hit.normal_W.dot(a - p_W) / hit.normal_W.dot(direction);
  return hit;
}

}  // namespace synthetic_dataset::world
