#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <nav_msgs/OccupancyGrid.h>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// An occupancy map as it was recorded.
struct RecordedMap {
  std::size_t width = 0;           ///< [cells], along the map's x
  std::size_t height = 0;          ///< [cells], along the map's y
  double resolution = 0.0;         ///< of a cell's side [m]
  Pose X_FM = Pose::Identity();    ///< of the lower left cell's corner in `frame`
  std::string frame;               ///< as the message's header has it
  std::vector<std::int8_t> cells;  ///< row by row, the lowest first: 0 (free) to 100, or -1
};

/// @throws Error when it is not a map: without cells or with another number of them than its sides
/// say,
///     without a size of its cells or a place
void checkMap(const RecordedMap& map);

/// The last nav_msgs/OccupancyGrid of a topic that was recorded in any of the bags: a map grows
/// while it is built, and the last is the fullest.
/// @param bag_files  bags that can be read
/// @throws Error when no bag has such a topic (with those of its type that there are), it has
///     messages of another type, or the last is not a map, as checkMap has it
[[nodiscard]] RecordedMap readMap(const std::vector<std::string>& bag_files,
                                  const std::string& topic);

/// What a message says.
/// @throws Error when it is not a map, as checkMap has it
[[nodiscard]] RecordedMap mapOf(const nav_msgs::OccupancyGrid& grid);

}  // namespace synthetic_dataset::motion
