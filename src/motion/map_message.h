#pragma once

#include <nav_msgs/OccupancyGrid.h>

#include "motion/recorded_map.h"

namespace synthetic_dataset::motion {

/// What a message says.
/// @throws Error when it is not a map, as checkMap has it
[[nodiscard]] RecordedMap mapOf(const nav_msgs::OccupancyGrid& grid);

}  // namespace synthetic_dataset::motion
