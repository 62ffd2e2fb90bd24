#pragma once

#include <memory>
#include <string>
#include <vector>

#include "motion/bag/bag.h"

namespace synthetic_dataset::motion {

/// Whether a file or folder is a bag of ROS 2: an SQLite database, a file of MCAP, one of these
/// that is compressed, or a folder with such files or with the metadata of rosbag2.
[[nodiscard]] bool isRos2Bag(const std::string& path);

/// The files of a bag: of one of ROS 2 in a folder, those in it with their metadata; else the path.
[[nodiscard]] std::vector<std::string> filesOfBag(const std::string& path);

/// Opens a bag of ROS 2. Its messages are shown as ROS 1 serialises them.
/// @throws Error as openBag() does
[[nodiscard]] std::unique_ptr<Bag> openRos2Bag(const std::string& path);

}  // namespace synthetic_dataset::motion
