#pragma once

#include "motion/recorded/recorded_map.h"
#include "synthetic_dataset/value.h"

/// A map that a running system has sent, as the group of settings `placement/received_map`. So the
/// core needs no ROS, and the manifest holds the map: a run is resumed with the same one alone, and
/// shards are merged where no such system runs.
namespace synthetic_dataset::randomize {

/// The group: `frame`, `width`, `height`, `resolution`, `origin` as [x, y, z, qx, qy, qz, qw], and
/// `cells` as runs of equal values, "0x1200 100x3 -1x40".
[[nodiscard]] Value settingsOf(const motion::RecordedMap& map);

/// The map again.
/// @throws Error naming the entry that is wrong
[[nodiscard]] motion::RecordedMap receivedMap(const Value& settings);

}  // namespace synthetic_dataset::randomize
