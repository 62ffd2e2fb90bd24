#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace synthetic_dataset::motion {

[[nodiscard]] bool isFile(const std::filesystem::path& path);

/// Whether a name has an ending of rosbag2's files: .db3, .mcap, or one of these followed by .zstd.
[[nodiscard]] bool hasStorageName(const std::string& file);

/// The files of a bag of ROS 2, in the order in which they were recorded: those that the folder's
/// metadata.yaml names, or, without one, those with rosbag2's file endings; or the file itself.
/// @param path  a folder or a file
/// @throws Error if the metadata cannot be read, or name a file that does not exist
[[nodiscard]] std::vector<std::string> storageFiles(const std::string& path);

}  // namespace synthetic_dataset::motion
