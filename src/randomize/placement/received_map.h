#pragma once

#include "motion/recorded/recorded_map.h"
#include "synthetic_dataset/value.h"

/// A map received from a running system, as the settings group `placement/received_map`. This way
/// the core needs no ROS, and the manifest holds the map: a run can only be resumed with the same
/// map, and shards can be merged where no such system runs.
namespace synthetic_dataset::randomize {

/// The settings group: `frame`, `width`, `height`, `resolution`, `origin` as [x, y, z, qx, qy, qz,
/// qw], and `cells` as runs of equal values, "0x1200 100x3 -1x40".
[[nodiscard]] Value settingsOf(const motion::RecordedMap& map);

/// Reads the map back from the settings.
/// @throws Error naming the entry that is wrong
[[nodiscard]] motion::RecordedMap receivedMap(const Value& settings);

}  // namespace synthetic_dataset::randomize
