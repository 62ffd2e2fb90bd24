#pragma once

#include <string>
#include <string_view>

#include "motion/ros2/storage.h"

namespace synthetic_dataset::motion {

/// Whether a file begins like an SQLite database
/// (https://www.sqlite.org/fileformat.html#magic_header_string).
[[nodiscard]] bool isSqlite(std::string_view start);

/// Opens a database of rosbag2's storage `sqlite3`: its tables `topics` and `messages`, which all
/// versions have, and `message_definitions`, which came with ROS 2 Iron
/// (https://github.com/ros2/rosbag2, rosbag2_storage_sqlite3).
/// @throws Error if it is damaged, or has other tables
[[nodiscard]] Storage openSqlite(const std::string& file);

}  // namespace synthetic_dataset::motion
