#pragma once

#include <cstdint>
#include <vector>

#include "config/config.h"
#include "motion/timeline.h"

namespace synthetic_dataset::run {

/// Leaves out the first times of each block that are nearer than the gap to the last time of the
/// block before it, so that no scene has a neighbour in another split that looks like it.
/// @return how many times each of the shares' blocks has now
[[nodiscard]] std::vector<std::int64_t> leaveOutGaps(const config::SplitConfig& config,
                                                     motion::Timeline& timeline);

}  // namespace synthetic_dataset::run
