#pragma once

#include <filesystem>
#include <iosfwd>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// Checks a run's settings: prints what the run would be and what is odd about it, and writes the
/// pictures `check.png` and `map.png` (with several motions `map_NAME.png`).
/// @param folder  for the pictures; made if it does not exist
/// @return whether nothing is odd
/// @throws ErrorList with everything that prevents the run
/// @throws Error when a picture cannot be written
[[nodiscard]] bool checkAndPrint(const Value& settings, const std::filesystem::path& folder,
                                 std::ostream& out);

}  // namespace synthetic_dataset::programs
