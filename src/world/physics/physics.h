#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/pose.h"
#include "world/physics/collision_models.h"

namespace synthetic_dataset::world {

/// A prop and its starting pose.
struct StartingProp {
  const PropModel* model = nullptr;  ///< has to outlive the physics
  Pose X_WM = Pose::Identity();
};

/// Props under gravity, among static collisions and objects whose motion is given from outside.
///
/// One thread, one fixed step, and an order that depends only on the order of the arguments: the
/// same calls give the same bits. In each step, contacts are found with everything where it is at
/// the step's start; objects have the velocity that takes them to where they are at its end, so
/// that they and the props that they push arrive together.
class Physics {
 public:
  /// @param gravity  [m/s^2]
  /// @param fixed  has to outlive this, as does what `objects` points to
  /// @param objects  initially without a pose; an articulated object contributes several
  Physics(const Eigen::Vector3d& gravity, Duration step, const std::vector<FixedCollision>& fixed,
          const std::vector<const MovingCollisions*>& objects,
          const std::vector<StartingProp>& props);
  ~Physics();
  Physics(const Physics&) = delete;
  Physics& operator=(const Physics&) = delete;

  /// Places the objects for the start: X_WO of each one that props can touch.
  void placeObjects(const std::vector<std::optional<Pose>>& X_WO);

  /// Simulates one step, at the end of which the objects are at X_WO. An object that has no pose at
  /// the step's start or end pushes nothing.
  /// @throws Error naming a prop whose pose is no longer finite
  void step(const std::vector<std::optional<Pose>>& X_WO);

  /// X_WM of a prop `since` after the last step (less than one step): a moving prop is extrapolated
  /// along its velocity, so that pictures taken between steps do not stutter.
  [[nodiscard]] Pose propPose(std::size_t prop, Duration since) const;

  /// Whether a prop has come to rest: it has been still for two seconds, and has not fallen off the
  /// world.
  [[nodiscard]] bool isAtRest(std::size_t prop) const;

  /// Whether no prop moves any more: each has come to rest, or has fallen off the world.
  [[nodiscard]] bool isAtRest() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::world
