#pragma once

#include <functional>
#include <string>

#include "motion/recorded/recorded_map.h"
#include "randomize/placement/occupancy_map.h"

namespace synthetic_dataset::randomize {

/// Limits on the probability that a cell is occupied; the defaults are those of map_server for maps
/// without a file.
struct Thresholds {
  double free = 0.196;     ///< a cell is free up to this
  double occupied = 0.65;  ///< a cell is occupied above this, and unknown in between
};

/// The map that map_server makes of a YAML file and its picture (image_loader.cpp of
/// https://github.com/ros-planning/navigation), with the lowest row of the picture as the map's
/// first. In the mode `scale`, map_server grades values between the thresholds; here they are
/// unknown. In the mode `raw`, a shade is the cell's value, as in a recorded map.
///
/// Unlike in map_server, a picture with a palette is read by its colours.
/// @param note  receives what the user should know: unknown cells that count as free by the file's
///     own thresholds
/// @throws Error naming the file and what is wrong, or ErrorList with all faults of the YAML
[[nodiscard]] OccupancyMap readMapFile(const std::string& file,
                                       const std::function<void(const std::string&)>& note = {});

/// A recorded map, whose frame is taken as the global one; move its X_FM if it is not. Values from
/// 0 to 100 are percentages; all others (mostly -1) are unknown.
/// @throws Error if the map is tilted
[[nodiscard]] OccupancyMap mapOf(const motion::RecordedMap& recorded,
                                 const Thresholds& thresholds = {});

}  // namespace synthetic_dataset::randomize
