#include "synthetic_dataset/nearest_name.h"

#include <algorithm>
#include <numeric>

namespace synthetic_dataset {
inline namespace v2 {
namespace {

/// The restricted Damerau-Levenshtein distance (optimal string alignment): insertions, deletions,
/// replacements and swaps of neighbours, with each letter part of at most one edit. Keeps only the
/// last rows of the table.
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = last[j] + (a[i] == b[j] ? 0 : 1);
      row[j + 1] = std::min({replaced, row[j] + 1, last[j + 1] + 1});
      if (i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j]) {
        row[j + 1] = std::min(row[j + 1], before_last[j - 1] + 1);
      }
    }
  }
  return row.back();
}

}  // namespace

std::optional<std::string> nearestName(const std::string& name,
                                       const std::vector<std::string>& candidates) {
  constexpr std::size_t kLongest = 500;  // longer than any name that a person may misspell
  std::optional<std::string> nearest;
  if (name.size() > kLongest) return nearest;
  std::size_t smallest = std::max<std::size_t>(name.size() / 3, 1) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t longer = std::max(name.size(), candidate.size());
    // The distance is at least the difference of the lengths.
    if (longer - std::min(name.size(), candidate.size()) >= smallest) continue;
    const std::size_t distance = editDistance(name, candidate);
    if (distance < smallest) {
      smallest = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string didYouMean(const std::string& name, const std::vector<std::string>& candidates) {
  const auto nearest = nearestName(name, candidates);
  return nearest ? "; did you mean '" + *nearest + "'?" : "";
}

}  // namespace v2
}  // namespace synthetic_dataset
