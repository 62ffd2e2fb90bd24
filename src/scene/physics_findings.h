#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/scene_facts.h"
#include "synthetic_dataset/pose.h"
#include "world/world.h"

namespace synthetic_dataset::scene {

/// What a world's physics has led to that a user should know of.
class PhysicsFindings {
 public:
  /// @param world  has to outlive this
  /// @param tolerance  physics/contact_tolerance [m]
  PhysicsFindings(const world::World& world, double tolerance)
      : world_(world), tolerance_(tolerance) {}

  /// Objects that are inside something now.
  /// @param warnings  gets one of each
  [[nodiscard]] std::vector<base::ContactFacts> contacts(
      Stamp stamp, std::vector<base::Warning>& warnings) const;

  /// Warns of models that have left the world, in each scene that is without them: what a scene
  /// says must not depend on which scenes this process has made before it.
  void addFallen(Stamp stamp, std::vector<base::Warning>& warnings) const;

 private:
  const world::World& world_;
  double tolerance_;
};

}  // namespace synthetic_dataset::scene
