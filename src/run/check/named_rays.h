#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "world/physics/ray_caster.h"
#include "world/world.h"

namespace synthetic_dataset::run {

/// The first model that a ray hits.
struct NamedHit {
  std::string model;
  double distance = 0.0;  ///< [m]
};

/// Casts rays against the visible surfaces of a world without its objects, in its current state.
class NamedRays {
 public:
  /// @param world  must have been advanced
  explicit NamedRays(const world::World& world);

  [[nodiscard]] std::optional<NamedHit> cast(const Eigen::Vector3d& p_G,
                                             const Eigen::Vector3d& direction_G,
                                             double range) const;

  /// The indices of the links inside whose surfaces a point lies: rays in three directions leave
  /// each of these more often than they enter it.
  [[nodiscard]] std::set<std::size_t> around(const Eigen::Vector3d& p_G) const;

  [[nodiscard]] const std::string& modelOf(std::size_t link) const { return models_[link]; }

 private:
  [[nodiscard]] std::set<std::size_t> crossedOddly(const Eigen::Vector3d& p_G,
                                                   const Eigen::Vector3d& direction_G) const;

  std::vector<std::string> models_;  ///< of the links
  world::RayCaster rays_;
};

}  // namespace synthetic_dataset::run
