#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/random/distribution.h"
#include "randomize/placement/placement_options.h"

namespace synthetic_dataset::randomize {

/// How distractors are put somewhere.
enum class DistractorMode {
  kFly,    ///< anywhere in the volume, in any orientation
  kStand,  ///< upright on what is below
  kDrop,   ///< as they lie when they have fallen from there
};

/// Things that stand, lie or fly about, so that a network does not take all that
/// stands out for an object.
struct DistractorOptions {
  int pool = 24;  ///< different ones, made once for the run
  base::Distribution count = base::Distribution::uniform({0.0}, {8.0});     ///< in a scene
  base::Distribution size = base::Distribution::logUniform({0.08}, {0.4});  ///< of a side [m]
  std::vector<std::string> models;      ///< URIs or paths of models, or of folders that hold some;
                                        ///< empty: boxes, balls and cylinders
  std::string textures = "procedural";  ///< of those; or an absolute folder, or `none`
  DistractorMode mode = DistractorMode::kFly;
  double fall_time = 10.0;  ///< [s] in which those that are dropped come to rest, or are left out
  Volume volume;            ///< where they are, or above where, or from where they fall
  std::optional<std::string> label_class;  ///< of all of them, as text; nothing: they have no label
  int tries = 50;  ///< for each; one without a place is left out of the scene
};

/// What a run calls its distractors: "distractor_1" is number 1.
[[nodiscard]] inline std::string distractorName(int number) {
  return "distractor_" + std::to_string(number);
}

}  // namespace synthetic_dataset::randomize
