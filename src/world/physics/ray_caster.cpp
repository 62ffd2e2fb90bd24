#include "world/physics/ray_caster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <btBulletCollisionCommon.h>

#include "world/physics/bullet_conversions.h"
#include "world/physics/bullet_shapes.h"

namespace synthetic_dataset::world {
namespace {

/// One mesh of one visual at its pose.
struct Target {
  std::size_t link = 0;
  Pose X_LV = Pose::Identity();
  Pose X_WV = Pose::Identity();
  const Mesh* mesh = nullptr;
  std::unique_ptr<btCollisionObject> object;
};

using Corners = std::array<Eigen::Vector3d, 3>;

Corners cornersOf(const Target& target, int triangle) {
  Corners corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t index = target.mesh->indices[3 * static_cast<std::size_t>(triangle) + i];
    corners[i] = target.X_WV * Eigen::Vector3d(target.mesh->positions[index].cast<double>());
  }
  return corners;
}

struct Ray {
  Eigen::Vector3d p_W;
  Eigen::Vector3d direction_W;
};

/// Whether the ray's line goes through the triangle: it lies on the same side of all three edges.
bool passesThrough(const Ray& ray, const Corners& corners) {
  std::array<double, 3> sides;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3d a = corners[i] - ray.p_W;
    const Eigen::Vector3d b = corners[(i + 1) % 3] - ray.p_W;
    sides[i] = ray.direction_W.dot(a.cross(b));
  }
  const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
  return *least >= 0.0 || *most <= 0.0;
}

RayHit hitOf(const Ray& ray, const Corners& corners, std::size_t link) {
  const auto& [a, b, c] = corners;
  RayHit hit;
  hit.link = link;
  hit.normal_W = (b - a).cross(c - a).normalized();
  if (hit.normal_W.dot(ray.direction_W) > 0.0) hit.normal_W = -hit.normal_W;
  hit.distance = hit.normal_W.dot(a - ray.p_W) / hit.normal_W.dot(ray.direction_W);
  return hit;
}

/// The nearest of Bullet's hits that are hits in double precision, too: for Bullet, a triangle
/// reaches a ten-thousandth of its size beyond its edges.
class NearestTriangle final : public btCollisionWorld::ClosestRayResultCallback {
 public:
  NearestTriangle(const std::vector<Target>& targets, const Ray& ray, double range)
      : ClosestRayResultCallback(toBullet(ray.p_W),
                                 toBullet(Eigen::Vector3d(ray.p_W + range * ray.direction_W))),
        targets_(targets),
        ray_(ray) {}

  btScalar addSingleResult(btCollisionWorld::LocalRayResult& result, bool in_world) override {
    const Target& target =
        targets_[static_cast<std::size_t>(result.m_collisionObject->getUserIndex())];
    const Corners corners = cornersOf(target, result.m_localShapeInfo->m_triangleIndex);
    if (!passesThrough(ray_, corners)) return m_closestHitFraction;
    hit_ = hitOf(ray_, corners, target.link);
    return ClosestRayResultCallback::addSingleResult(result, in_world);
  }

  [[nodiscard]] const std::optional<RayHit>& hit() const { return hit_; }

 private:
  const std::vector<Target>& targets_;
  const Ray& ray_;
  std::optional<RayHit> hit_;
};

}  // namespace

struct RayCaster::Impl {
  void add(const Surface& surface, const Pose& X_LV, std::size_t link);

  std::map<const Mesh*, BulletShape> shapes;  ///< only used for look-up: its order does not matter
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
  const Ray ray{p_W, direction_W.normalized()};
  NearestTriangle nearest(impl_->targets, ray, range);
  impl_->world.rayTest(nearest.m_rayFromWorld, nearest.m_rayToWorld, nearest);
  return nearest.hit();
}

}  // namespace synthetic_dataset::world
