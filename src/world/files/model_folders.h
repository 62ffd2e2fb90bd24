#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace synthetic_dataset::world {

/// The models below a folder, sorted: folders with a model.config, and .sdf and .urdf files that
/// are not in such a folder.
/// @throws Error if there is no such folder
[[nodiscard]] std::vector<std::filesystem::path> findModels(const std::filesystem::path& folder);

/// The path or URI of a model, unchanged; for a folder that is not a model itself, all models below
/// it.
/// @throws Error if a folder contains no model
[[nodiscard]] std::vector<std::string> modelsAt(const std::string& path_or_uri);

}  // namespace synthetic_dataset::world
