#pragma once

#include <optional>
#include <string>
#include <vector>

namespace synthetic_dataset {
inline namespace v2 {

/// The candidate with the smallest edit distance to `name` (Damerau-Levenshtein), if `name` may be
/// a misspelling of it: at most a third of the letters, or one, differ.
[[nodiscard]] std::optional<std::string> nearestName(const std::string& name,
                                                     const std::vector<std::string>& candidates);

/// "; did you mean 'x'?" for the end of a message, or "" if no candidate is near enough.
[[nodiscard]] std::string didYouMean(const std::string& name,
                                     const std::vector<std::string>& candidates);

}  // namespace v2
}  // namespace synthetic_dataset
