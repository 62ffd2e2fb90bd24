#pragma once

#include "randomize/appearance/randomize_options.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::config {

/// Reads `background` of `randomize`: a colour, or a group with `colour`, `pictures` and what
/// belongs to these.
[[nodiscard]] randomize::BackgroundRandomization readBackground(Parameters randomize);

}  // namespace synthetic_dataset::config
