#pragma once

#include <memory>
#include <string>
#include <vector>

#include "motion/bag/bag.h"

namespace synthetic_dataset::motion {

/// Whether a file or folder is a bag of ROS 2: an SQLite database, an MCAP file, a compressed one
/// of these, or a folder with such files or with rosbag2's metadata.
[[nodiscard]] bool isRos2Bag(const std::string& path);

/// The files of a bag: for a ROS 2 bag folder, the files in it and their metadata; otherwise the
/// path itself.
[[nodiscard]] std::vector<std::string> filesOfBag(const std::string& path);

/// Opens a bag of ROS 2. Its messages are returned in ROS 1's serialisation.
/// @throws Error as openBag() does
[[nodiscard]] std::unique_ptr<Bag> openRos2Bag(const std::string& path);

}  // namespace synthetic_dataset::motion
