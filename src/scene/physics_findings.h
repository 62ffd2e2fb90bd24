#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/scene_facts.h"
#include "synthetic_dataset/pose.h"
#include "world/world.h"

namespace synthetic_dataset::scene {

/// Results of a world's physics that the user should know about.
class PhysicsFindings {
 public:
  /// @param world  has to outlive this
  /// @param tolerance  physics/contact_tolerance [m]
  PhysicsFindings(const world::World& world, double tolerance)
      : world_(world), tolerance_(tolerance) {}

  /// Objects that are inside something now.
  /// @param warnings  receives one for each
  [[nodiscard]] std::vector<base::ContactFacts> contacts(
      Stamp stamp, std::vector<base::Warning>& warnings) const;

  /// Warns of models that have left the world, in every scene that lacks them: a scene's warnings
  /// must not depend on which scenes this process has made before it.
  void addFallen(Stamp stamp, std::vector<base::Warning>& warnings) const;

 private:
  const world::World& world_;
  double tolerance_;
};

}  // namespace synthetic_dataset::scene
