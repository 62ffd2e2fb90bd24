#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/random/random_source.h"
#include "randomize/placement/placement_options.h"
#include "randomize/placement/standing_place.h"
#include "randomize/placement/surroundings.h"
#include "synthetic_dataset/cuboid.h"
#include "world/world.h"

namespace synthetic_dataset::randomize {

/// Places some of a world's distractors in each scene, clear of everything else.
class DistractorPlacer {
 public:
  /// @param world  must outlive this, and so must its surroundings
  /// @param boxes_M  around each distractor, in its own frame
  DistractorPlacer(const DistractorOptions& config, std::vector<Cuboid> boxes_M,
                   world::World& world, Surroundings& surroundings, std::uint64_t seed);

  /// Puts a scene's distractors into the world, after the objects have been placed.
  /// @param cameras_G  to keep away from
  /// @param objects_G  the boxes around the objects; used as the region for distractors if the
  ///     options give no volume
  /// @return the numbers of the distractors in the scene, from 1
  std::vector<int> place(std::int64_t scene, const std::vector<Eigen::Vector3d>& cameras_G = {},
                         const std::vector<Cuboid>& objects_G = {});

 private:
  [[nodiscard]] std::vector<std::size_t> choose(std::int64_t scene) const;
  [[nodiscard]] PoseOrReason draw(std::size_t distractor, base::RandomSource& source) const;
  [[nodiscard]] std::optional<Pose> findPlace(std::size_t distractor, std::int64_t scene,
                                              const std::vector<std::optional<Pose>>& placed,
                                              const std::vector<Eigen::Vector3d>& cameras_G) const;
  void drop(std::vector<std::optional<Pose>>& X_GM,
            const std::vector<Eigen::Vector3d>& cameras_G) const;
  [[nodiscard]] bool isNearAny(const std::vector<Eigen::Vector3d>& cameras_G,
                               std::size_t distractor, const Pose& X_GM) const;

  DistractorOptions config_;
  std::vector<Cuboid> boxes_M_;
  world::World& world_;
  Surroundings& surroundings_;
  std::uint64_t seed_;
  Volume volume_;  ///< for the current scene
};

}  // namespace synthetic_dataset::randomize
