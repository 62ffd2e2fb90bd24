#pragma once

#include <vector>

#include "randomize/appearance/variety/model_parts.h"
#include "world/description.h"

namespace synthetic_dataset::randomize {

/// A section of a model's height, bounded by sudden changes of width: the foot of a cone, the rim
/// of a barrel.
struct HeightLevel {
  double low;
  double high;
  double foot_radius;  ///< distance from the model's middle to its edge at the foot [m]
  double top_radius;   ///< and at the top
};

/// The levels of a model from its foot to its top. Only one if the width changes gradually, or in
/// more places than it would on a thing with a foot.
/// @param parts  of the model, which must be visible
[[nodiscard]] std::vector<HeightLevel> levelsOf(const world::Model& model, const ModelParts& parts);

/// The level that contains a height; borders belong to the level below.
[[nodiscard]] std::size_t levelAt(const std::vector<HeightLevel>& levels, double z);

}  // namespace synthetic_dataset::randomize
