#pragma once

#include <optional>
#include <string>
#include <vector>

namespace synthetic_dataset {
inline namespace v2 {

/// The candidate that is spelt most nearly like `name` (by Levenshtein's distance), if it is near
/// enough to be what a typing mistake meant: at most a third of the letters differ.
[[nodiscard]] std::optional<std::string> nearestName(const std::string& name,
                                                     const std::vector<std::string>& candidates);

/// "; did you mean 'x'?" for the end of a message, or nothing.
[[nodiscard]] std::string didYouMean(const std::string& name,
                                     const std::vector<std::string>& candidates);

}  // namespace v2
}  // namespace synthetic_dataset
