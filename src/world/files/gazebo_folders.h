#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace synthetic_dataset::world {

/// The folders that an environment variable lists, separated by colons.
[[nodiscard]] std::vector<std::string> foldersOf(const char* variable);

/// The folders in which an installed Gazebo Classic keeps its `media` and `models`: gazebo-11,
/// gazebo-9 and the like in the `share` of /usr/local, /usr and a conda environment, the newest of
/// each first.
[[nodiscard]] std::vector<std::filesystem::path> installedGazebos();

}  // namespace synthetic_dataset::world
