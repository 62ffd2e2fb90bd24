#pragma once

#include <string>
#include <utility>

namespace synthetic_dataset::world {

/// SDF's version: 1 and 6 of "1.6".
using SdfVersion = std::pair<long, long>;

/// The newest version whose elements this program knows.
inline constexpr SdfVersion kNewestSdfVersion{1, 12};

/// Whether a text is a version: "1.6".
[[nodiscard]] bool isSdfVersion(const std::string& text);

/// @param text  may be null: 0, 0
[[nodiscard]] SdfVersion parseSdfVersion(const char* text);

}  // namespace synthetic_dataset::world
