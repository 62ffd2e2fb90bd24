#pragma once

#include <string>

namespace synthetic_dataset::output {

/// A path as the manifest of a folder lists it: relative where it lies below the folder.
/// @param folder  absolute and normalised
/// @param path  absolute; a folder's ends in `/`
[[nodiscard]] std::string listedPath(const std::string& folder, const std::string& path);

/// The absolute path that a manifest of this folder lists; a folder's keeps the `/` at its end.
/// @throws Error for a path that leads out of the folder
[[nodiscard]] std::string absoluteFrom(const std::string& folder, const std::string& listed);

}  // namespace synthetic_dataset::output
