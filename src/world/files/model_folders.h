#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace synthetic_dataset::world {

/// The models below a folder, sorted: folders with a model.config, and .sdf and .urdf files that
/// are in no such folder.
/// @throws Error if there is no such folder
[[nodiscard]] std::vector<std::filesystem::path> findModels(const std::filesystem::path& folder);

/// A model that is given by its path or URI, as it is; for a folder that is none, all models below
/// it.
/// @throws Error if a folder has no model
[[nodiscard]] std::vector<std::string> modelsAt(const std::string& path_or_uri);

}  // namespace synthetic_dataset::world
