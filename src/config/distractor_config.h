#pragma once

#include <optional>

#include "randomize/placement/placement_options.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::config {

/// Reads the group `distractors` of `randomize`, or nothing where there is none.
[[nodiscard]] std::optional<randomize::DistractorOptions> readDistractors(Parameters randomize);

}  // namespace synthetic_dataset::config
