#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace synthetic_dataset::motion {

[[nodiscard]] bool isFile(const std::filesystem::path& path);

/// Whether a name ends as rosbag2's files do: .db3, .mcap, and these with .zstd behind.
[[nodiscard]] bool hasStorageName(const std::string& file);

/// The files of a bag of ROS 2, in the order in which they were recorded: those that the folder's
/// metadata.yaml names, or, without one, those that are named as rosbag2 does; or the file itself.
/// @param path  a folder or a file
/// @throws Error where the metadata cannot be read, or name a file that is not there
[[nodiscard]] std::vector<std::string> storageFiles(const std::string& path);

}  // namespace synthetic_dataset::motion
