#include "randomize/placement/miss_reasons.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace synthetic_dataset::randomize {

std::string reasonsText(const std::map<std::string, int>& misses) {
  std::vector<std::pair<int, std::string>> by_count;
  for (const auto& [reason, count] : misses) by_count.emplace_back(count, reason);
  std::sort(by_count.rbegin(), by_count.rend());
  constexpr std::size_t kMostTold = 4;
  std::string text;
  for (std::size_t i = 0; i < std::min(kMostTold, by_count.size()); ++i) {
    text += (i > 0 ? ", " : "") + std::to_string(by_count[i].first) + " " + by_count[i].second;
  }
  return text;
}

}  // namespace synthetic_dataset::randomize
