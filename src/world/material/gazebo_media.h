#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace synthetic_dataset::world {

/// The folders in which an installed Gazebo Classic keeps its `media`: those of
/// GAZEBO_RESOURCE_PATH, then /usr/share/gazebo*, the newest first.
[[nodiscard]] std::vector<std::filesystem::path> gazeboResourceFolders();

/// A file or a folder of Gazebo's, by its path below a resource folder
/// ("media/materials/scripts/gazebo.material"), or nothing where there is none.
[[nodiscard]] std::optional<std::filesystem::path> findGazeboResource(const std::string& path);

}  // namespace synthetic_dataset::world
