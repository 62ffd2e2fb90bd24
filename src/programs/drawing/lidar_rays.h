#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "output/manifest/run_description.h"

namespace synthetic_dataset::programs {

/// The number of rays in a sweep, by lidar name, for the lidars that the settings of a run
/// describe. Excludes scanners from a world's files and lidars that belong to single motions.
[[nodiscard]] std::map<std::string, std::int64_t> raysOfLidars(const output::RunDescription& run);

}  // namespace synthetic_dataset::programs
