#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/placement_config.h"
#include "random/distribution.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::config {

/// Things without a label that stand or fly about, so that a network does not take all that stands
/// out for an object.
struct DistractorConfig {
  int pool = 24;  ///< different ones, made once for the run
  random::Distribution count = random::Distribution::uniform({0.0}, {8.0});     ///< in a scene
  random::Distribution size = random::Distribution::logUniform({0.08}, {0.4});  ///< of a side [m]
  std::vector<std::string> models;      ///< URIs or paths; empty: boxes, balls and cylinders
  std::string textures = "procedural";  ///< of those; or an absolute folder, or `none`
  bool fly = true;                      ///< else they stand on what is below
  Volume volume;                        ///< where they are; those that stand, on what is below
  int tries = 50;                       ///< for each; one without a place is left out of the scene
};

/// Reads the group `distractors` of `randomize`, or nothing where there is none.
[[nodiscard]] std::optional<DistractorConfig> readDistractors(const Parameters& randomize);

}  // namespace synthetic_dataset::config
