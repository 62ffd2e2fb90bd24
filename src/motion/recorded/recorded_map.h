#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <nav_msgs/OccupancyGrid.h>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// A recorded occupancy map.
struct RecordedMap {
  std::size_t width = 0;           ///< [cells], along the map's x
  std::size_t height = 0;          ///< [cells], along the map's y
  double resolution = 0.0;         ///< length of a cell's side [m]
  Pose X_FM = Pose::Identity();    ///< of the lower left cell's corner in `frame`
  std::string frame;               ///< from the message's header
  std::vector<std::int8_t> cells;  ///< row by row, the lowest first: 0 (free) to 100, or -1
};

/// @throws Error if it is not a valid map: without cells, with a number of cells other than its
///     sides imply, or without a valid resolution or origin
void checkMap(const RecordedMap& map);

/// The last nav_msgs/OccupancyGrid of a topic in all bags: a map grows while it is built, so the
/// last one is the most complete.
/// @param bag_files  bags that can be read
/// @throws Error if no bag has such a topic (listing the topics of its type), its messages are of
///     another type, or checkMap() rejects the last one
[[nodiscard]] RecordedMap readMap(const std::vector<std::string>& bag_files,
                                  const std::string& topic);

/// Converts a message.
/// @throws Error if checkMap() rejects it
[[nodiscard]] RecordedMap mapOf(const nav_msgs::OccupancyGrid& grid);

}  // namespace synthetic_dataset::motion
