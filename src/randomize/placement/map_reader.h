#pragma once

#include <functional>
#include <string>

#include "motion/recorded/recorded_map.h"
#include "randomize/placement/occupancy_map.h"

namespace synthetic_dataset::randomize {

/// How likely it may be that something stands on a cell; map_server's own, where it has no file.
struct Thresholds {
  double free = 0.196;     ///< a cell is free up to it
  double occupied = 0.65;  ///< and occupied from beyond it on; unknown between the two
};

/// The map that map_server makes of a YAML file and its picture (image_loader.cpp of
/// https://github.com/ros-planning/navigation), whose lowest row is the map's first. The mode
/// `scale` grades what lies between the thresholds: it is unknown here. In the mode `raw` a shade
/// is the number that the cell has, as in a recorded map.
///
/// Unlike there, a picture with a palette counts by its colours.
/// @param note  takes what the user should know: unknown cells that count as free by the file's own
///     thresholds
/// @throws Error naming the file and what is wrong, ErrorList with all that is wrong with the YAML
[[nodiscard]] OccupancyMap readMapFile(const std::string& file,
                                       const std::function<void(const std::string&)>& note = {});

/// A recorded map, whose frame is the global one; move its X_FM where it is another. Its numbers
/// from 0 to 100 are percentages, all others (-1 above all) unknown.
/// @throws Error when the map is tilted
[[nodiscard]] OccupancyMap mapOf(const motion::RecordedMap& recorded,
                                 const Thresholds& thresholds = {});

}  // namespace synthetic_dataset::randomize
