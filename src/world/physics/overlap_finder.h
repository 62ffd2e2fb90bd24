#pragma once

#include <memory>
#include <string>
#include <vector>

#include "synthetic_dataset/pose.h"
#include "world/physics/collision_models.h"
#include "world/world.h"

namespace synthetic_dataset::world {

/// Finds objects that are inside one another or inside static models.
class OverlapFinder {
 public:
  /// @param fixed, bodies  have to outlive this
  /// @param names  of the objects that the bodies belong to: an object may have several
  OverlapFinder(const std::vector<FixedCollision>& fixed,
                const std::vector<MovingCollisions>& bodies, std::vector<std::string> names);
  ~OverlapFinder();
  OverlapFinder(const OverlapFinder&) = delete;
  OverlapFinder& operator=(const OverlapFinder&) = delete;

  /// Each pair deeper than `tolerance` [m] once, with its deepest contact, sorted by names.
  [[nodiscard]] std::vector<Interpenetration> find(const std::vector<Pose>& X_WB,
                                                   double tolerance) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::world
