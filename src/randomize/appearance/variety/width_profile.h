#pragma once

#include <vector>

#include "randomize/appearance/variety/model_parts.h"
#include "world/description.h"

namespace synthetic_dataset::randomize {

/// A section of a model's height, below and above which it is suddenly wider or narrower: the foot
/// of a cone, the rim of a barrel.
struct HeightLevel {
  double low;
  double high;
  double foot_radius;  ///< how far it reaches from the model's middle at its foot [m]
  double top_radius;   ///< and at its top
};

/// The levels of a model from its foot to its top: one where its width changes gradually, or in
/// more places than a thing has that stands on a foot.
/// @param parts  of the model, which can be seen
[[nodiscard]] std::vector<HeightLevel> levelsOf(const world::Model& model, const ModelParts& parts);

/// The level that a height is in; borders belong to the level below.
[[nodiscard]] std::size_t levelAt(const std::vector<HeightLevel>& levels, double z);

}  // namespace synthetic_dataset::randomize
