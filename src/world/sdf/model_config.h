#pragma once

#include <filesystem>
#include <string>
#include <utility>

namespace synthetic_dataset::world {

/// A version of SDF, "1.10" after "1.9".
using SdfVersion = std::pair<long, long>;

/// Whether a text is a number, or two with a point between them.
[[nodiscard]] bool isSdfVersion(const std::string& text);

/// @param text  null counts as 0.0
[[nodiscard]] SdfVersion parseSdfVersion(const char* text);

/// The newest that the library here knows.
[[nodiscard]] SdfVersion newestSdfVersion();

/// The model file of a model folder: of those that its model.config (or manifest.xml, of old) lists
/// and that are there, the one with the highest version of SDF that the library here knows, else
/// the lowest of those that it does not.
/// @throws Error if the folder has no model.config, or that lists no file that there is
[[nodiscard]] std::filesystem::path modelFileOf(const std::filesystem::path& folder);

}  // namespace synthetic_dataset::world
