#pragma once

#include "randomize/appearance/randomize_options.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::config {

/// Reads the group `randomize`, all of which may be left out.
[[nodiscard]] randomize::Randomization readRandomization(Parameters root);

}  // namespace synthetic_dataset::config
