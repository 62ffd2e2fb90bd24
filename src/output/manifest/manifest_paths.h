#pragma once

#include <string>

namespace synthetic_dataset::output {

/// A path as a manifest in this folder lists it: relative if it is below the folder.
/// @param folder  absolute and normalised
/// @param path  absolute; ends in `/` if it is a folder
[[nodiscard]] std::string listedPath(const std::string& folder, const std::string& path);

/// The absolute path for one that a manifest in this folder lists; a folder keeps its trailing `/`.
/// @throws Error for a path that leads out of the folder
[[nodiscard]] std::string absoluteFrom(const std::string& folder, const std::string& listed);

}  // namespace synthetic_dataset::output
