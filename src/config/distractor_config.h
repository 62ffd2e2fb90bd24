#pragma once

#include <optional>

#include "placement/distractor_options.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::config {

/// Reads the group `distractors` of `randomize`, or nothing where there is none.
[[nodiscard]] std::optional<placement::DistractorOptions> readDistractors(
    Parameters randomize);

}  // namespace synthetic_dataset::config
