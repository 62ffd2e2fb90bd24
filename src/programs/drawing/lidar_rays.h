#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "output/manifest/run_description.h"

namespace synthetic_dataset::programs {

/// How many rays a sweep of each lidar has that the settings of a run describe, by its name. Not of
/// scanners of a world's files, nor of those that belong to single motions.
[[nodiscard]] std::map<std::string, std::int64_t> raysOfLidars(const output::RunDescription& run);

}  // namespace synthetic_dataset::programs
