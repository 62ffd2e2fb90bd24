#pragma once

#include <filesystem>

namespace synthetic_dataset::world {

/// The model file of a model folder: of the files that its model.config (formerly manifest.xml)
/// lists and that exist, the one with the highest version of SDF that this program knows, else the
/// one with the lowest version that it does not.
/// @throws Error if the folder has no model.config, or if that lists no file that exists
[[nodiscard]] std::filesystem::path modelFileOf(const std::filesystem::path& folder);

}  // namespace synthetic_dataset::world
