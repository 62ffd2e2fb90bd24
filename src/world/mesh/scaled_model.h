#pragma once

#include "world/description.h"

namespace synthetic_dataset::world {

/// A model that is larger or smaller in all directions about its own origin, and of the same
/// material: its mass goes with the third power of the factor.
/// @param factor  > 0
[[nodiscard]] Model scaled(Model model, double factor);

}  // namespace synthetic_dataset::world
