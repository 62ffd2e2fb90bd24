#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/pose.h"
#include "world/physics/collision_models.h"

namespace synthetic_dataset::world {

/// A prop, and where it starts.
struct StartingProp {
  const PropModel* model = nullptr;  ///< has to outlive the physics
  Pose X_WM = Pose::Identity();
};

/// Props under gravity, among things that stand and objects that are moved from outside.
///
/// One thread, one fixed step, an order that depends on nothing but the order of the arguments: the
/// same calls give the same bits. Per step, contacts are found with everything at the step's start;
/// objects carry the velocity that takes them to its end, so they and the props that they push
/// arrive together.
class Physics {
 public:
  /// @param gravity  [m/s^2]
  /// @param fixed  and what objects point to has to outlive this
  /// @param objects  at first without a pose; an articulated object is several here
  Physics(const Eigen::Vector3d& gravity, Duration step, const std::vector<FixedCollision>& fixed,
          const std::vector<const MovingCollisions*>& objects,
          const std::vector<StartingProp>& props);
  ~Physics();
  Physics(const Physics&) = delete;
  Physics& operator=(const Physics&) = delete;

  /// Puts the objects where they are at the start: X_WO of each that props touch.
  void placeObjects(const std::vector<std::optional<Pose>>& X_WO);

  /// Simulates one step, at the end of which the objects are at X_WO. One that has no pose at the
  /// step's start or end pushes nothing.
  /// @throws Error naming a prop whose pose is no longer finite
  void step(const std::vector<std::optional<Pose>>& X_WO);

  /// X_WM of a prop `since` after the last step (less than one step): one that moves is taken on
  /// along its velocity, so that pictures taken between steps do not stutter.
  [[nodiscard]] Pose propPose(std::size_t prop, Duration since) const;

  /// Whether a prop has come to rest: it has been still for two seconds, and lies somewhere.
  [[nodiscard]] bool isAtRest(std::size_t prop) const;

  /// Whether no prop moves any more: each has come to rest, or has fallen off the world.
  [[nodiscard]] bool isAtRest() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::world
