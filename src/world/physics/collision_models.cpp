#include "world/physics/collision_models.h"

#include <algorithm>
#include <optional>

#include <Eigen/Eigenvalues>

#include <btBulletCollisionCommon.h>

#include "synthetic_dataset/errors.h"
#include "world/physics/bullet_conversions.h"
#include "world/physics/mass_properties.h"

namespace synthetic_dataset::world {
namespace {

constexpr double kSamePlace = 1e-6;  // [m]: far below what contacts resolve

std::string nameOf(const Model& model, const Collision& collision) {
  return "model '" + model.name + "': collision '" + collision.name + "'";
}

/// Calls `visit(link, collision)` for each collision of a model, and collects the errors of all.
template <class Visit>
void forEachCollision(const Model& model, const Visit& visit) {
  std::vector<std::string> errors;
  for (const Link& link : model.links) {
    for (const Collision& collision : link.collisions) {
      try {
        visit(link, collision);
      } catch (const Error& error) {
        errors.push_back(nameOf(model, collision) + ": " + error.what());
      }
    }
  }
  if (!errors.empty()) throw ErrorList(std::move(errors));
}

bool isPlane(const Collision& collision) {
  return std::holds_alternative<PlaneShape>(collision.shape);
}

/// Whether a collision gives a part of a moving body.
bool hasConvexPart(const Collision& collision) {
  const auto* mesh = std::get_if<MeshShape>(&collision.shape);
  const bool empty = mesh != nullptr && (mesh->mesh == nullptr || mesh->mesh->positions.empty());
  return !empty && !isPlane(collision);
}

bool isDiagonal(const Eigen::Matrix3d& moments) {
  const Eigen::Matrix3d diagonal = moments.diagonal().asDiagonal();
  return (moments - diagonal).cwiseAbs().maxCoeff() <= 1e-6 * moments.trace();
}

/// The pose of the model's only collision that can move, if it has exactly one.
std::optional<Pose> onlyCollision(const Model& model) {
  std::optional<Pose> only;
  for (const Link& link : model.links) {
    for (const Collision& collision : link.collisions) {
      if (!hasConvexPart(collision)) continue;
      if (only) return std::nullopt;
      only = link.X_ML * collision.X_LC;
    }
  }
  return only;
}

/// A frame at the centre of mass along the principal axes. If these are the model's own axes, or
/// those of its only collision, they are used: the latter saves Bullet the compound shape.
Pose principalFrame(const Model& model, const MassProperties& mass) {
  Pose X_MB = Pose::Identity();
  X_MB.translation() = mass.centre_F;
  const std::optional<Pose> X_MC = onlyCollision(model);
  if (X_MC && (X_MC->translation() - mass.centre_F).norm() < kSamePlace &&
      isDiagonal(X_MC->linear().transpose() * mass.moments_F * X_MC->linear())) {
    return *X_MC;
  }
  if (isDiagonal(mass.moments_F)) return X_MB;
  Eigen::Matrix3d axes =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(mass.moments_F).eigenvectors();
  if (axes.determinant() < 0.0) axes.col(2) = -axes.col(2);
  X_MB.linear() = axes;
  return X_MB;
}

/// The links of a model move as one, so those without gravity make it lighter.
double gravityShare(const Model& model) {
  double all = 0.0;
  double heavy = 0.0;
  for (const Link& link : model.links) {
    const double mass = massOf(link).mass;
    all += mass;
    if (link.has_gravity) heavy += mass;
  }
  return all > 0.0 ? heavy / all : 1.0;
}

void requireSound(const Model& model, const PropModel& prop) {
  const bool sound = std::isfinite(prop.mass) && prop.mass > 0.0 && prop.moments_B.allFinite() &&
                     prop.moments_B.minCoeff() > 0.0 && prop.X_MB.matrix().allFinite();
  if (sound) return;
  throw ErrorList({"model '" + model.name +
                   "': its links' masses and moments of inertia do not make a body that can move; "
                   "each mass and each principal moment has to be finite and above 0"});
}

}  // namespace

MovingCollisions::MovingCollisions() = default;
MovingCollisions::MovingCollisions(MovingCollisions&&) noexcept = default;
MovingCollisions& MovingCollisions::operator=(MovingCollisions&&) noexcept = default;
MovingCollisions::~MovingCollisions() = default;

btCollisionShape* MovingCollisions::whole() const {
  if (parts.empty()) return nullptr;
  const bool alone = parts.size() == 1 && parts.front().X_BP.isApprox(Pose::Identity(), kSamePlace);
  return alone ? parts.front().shape.shape.get() : compound.get();
}

std::vector<FixedCollision> fixedCollisions(const Model& model) {
  std::vector<FixedCollision> result;
  forEachCollision(model, [&](const Link& link, const Collision& collision) {
    FixedCollision fixed_collision;
    fixed_collision.model = model.name;
    fixed_collision.X_WC = model.X_WM * link.X_ML * collision.X_LC;
    fixed_collision.shape = makeFixedShape(collision.shape);
    fixed_collision.surface = {collision.friction, collision.restitution};
    if (fixed_collision.shape.shape) result.push_back(std::move(fixed_collision));
  });
  return result;
}

std::optional<double> deepestPoint(const std::vector<FixedCollision>& collisions,
                                   const Eigen::Vector3d& down) {
  std::optional<double> deepest;
  for (const FixedCollision& each : collisions) {
    double depth = down.dot(each.X_WC.translation());
    if (!each.shape.shape->isInfinite()) {
      btVector3 low;
      btVector3 high;
      each.shape.shape->getAabb(toBullet(each.X_WC), low, high);
      const Eigen::Vector3d half = 0.5 * (fromBullet(high) - fromBullet(low));
      depth = down.dot(0.5 * (fromBullet(high) + fromBullet(low))) + down.cwiseAbs().dot(half);
    }
    deepest = std::max(deepest.value_or(depth), depth);
  }
  return deepest;
}

MovingCollisions movingCollisions(const Model& model, const Pose& X_MB) {
  MovingCollisions result;
  const Pose X_BM = X_MB.inverse();
  forEachCollision(model, [&](const Link& link, const Collision& collision) {
    ConvexPart part = makeConvexPart(collision.shape, X_BM * link.X_ML * collision.X_LC);
    if (isPlane(collision)) {
      result.notes.push_back(nameOf(model, collision) +
                             ": an infinite plane cannot move; the simulation leaves it out");
    }
    if (part.shape.shape == nullptr) return;
    result.parts.push_back(std::move(part));
    result.surfaces.push_back({collision.friction, collision.restitution});
  });
  result.compound = std::make_unique<btCompoundShape>();
  for (const ConvexPart& part : result.parts) {
    result.compound->addChildShape(toBullet(part.X_BP), part.shape.shape.get());
  }
  return result;
}

bool canMove(const Model& model) {
  return std::any_of(model.links.begin(), model.links.end(), [](const Link& link) {
    return std::any_of(link.collisions.begin(), link.collisions.end(), hasConvexPart);
  });
}

PropModel makeProp(const Model& model) {
  PropModel prop;
  const MassProperties mass = massOf(model);
  prop.name = model.name;
  prop.mass = mass.mass;
  prop.X_MB = principalFrame(model, mass);
  prop.moments_B =
      (prop.X_MB.linear().transpose() * mass.moments_F * prop.X_MB.linear()).diagonal();
  prop.gravity_share = gravityShare(model);
  prop.collisions = movingCollisions(model, prop.X_MB);
  requireSound(model, prop);
  return prop;
}

}  // namespace synthetic_dataset::world
