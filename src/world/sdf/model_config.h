#pragma once

#include <filesystem>

namespace synthetic_dataset::world {

/// The model file of a model folder: of those that its model.config (or manifest.xml, of old) lists
/// and that are there, the one with the highest version of SDF that is known here, else the
/// lowest of those that it does not.
/// @throws Error if the folder has no model.config, or that lists no file that there is
[[nodiscard]] std::filesystem::path modelFileOf(const std::filesystem::path& folder);

}  // namespace synthetic_dataset::world
