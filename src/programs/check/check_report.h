#pragma once

#include <filesystem>
#include <iosfwd>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// Checks a run's settings: prints what it would be and what is odd about it, and leaves the
/// pictures `check.png` and `map.png` (with several motions `map_NAME.png`).
/// @param folder  for the pictures; made if it is not there
/// @return whether nothing is odd
/// @throws ErrorList with all that keeps the run from beginning
/// @throws Error when a picture cannot be written
[[nodiscard]] bool checkAndPrint(const Value& settings, const std::filesystem::path& folder,
                                 std::ostream& out);

}  // namespace synthetic_dataset::programs
