#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "world/physics/ray_caster.h"
#include "world/world.h"

namespace synthetic_dataset::randomize {

/// Casts rays against what a camera would see of a world without its objects and distractors: the
/// surfaces of static models, and of props where they are now.
class Surroundings {
 public:
  /// @param world  must outlive this
  explicit Surroundings(const world::World& world);

  /// The nearest surface within `range` [m] of a point in a direction.
  [[nodiscard]] std::optional<world::RayHit> cast(const Eigen::Vector3d& p_G,
                                                  const Eigen::Vector3d& direction_G, double range);

 private:
  const world::World& world_;
  std::vector<std::size_t> links_;  ///< those of the world
  std::int64_t prop_revision_;      ///< for which `rays_` is up to date
  world::RayCaster rays_;
};

}  // namespace synthetic_dataset::randomize
