#pragma once

#include <map>
#include <string>

namespace synthetic_dataset::randomize {

/// Why places were rejected, and how often: "612 were inside 'shelf', 3 were too near 'alpha'", the
/// most frequent reasons first.
[[nodiscard]] std::string reasonsText(const std::map<std::string, int>& misses);

}  // namespace synthetic_dataset::randomize
