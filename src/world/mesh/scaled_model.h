#pragma once

#include "world/description.h"

namespace synthetic_dataset::world {

/// A model scaled uniformly about its own origin, with unchanged density: its mass grows with the
/// cube of the factor.
/// @param factor  > 0
[[nodiscard]] Model scaled(Model model, double factor);

}  // namespace synthetic_dataset::world
