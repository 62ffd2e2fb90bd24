#pragma once

#include <string>

namespace synthetic_dataset::motion {

/// Whether a file or folder is a bag of ROS 2: an SQLite database with its tables, a file of MCAP,
/// or a folder with the metadata of rosbag2.
[[nodiscard]] bool isRos2Bag(const std::string& path);

/// "is a bag of ROS 2; ..." with the command that makes one of ROS 1 of it.
[[nodiscard]] std::string convertAdvice(const std::string& path);

}  // namespace synthetic_dataset::motion
