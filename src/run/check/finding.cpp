#include "run/check/finding.h"

#include <algorithm>
#include <utility>

#include "base/name_list.h"

namespace synthetic_dataset::run {
namespace {

constexpr std::size_t kMostAlike = 4;   // number that are still reported individually
constexpr std::size_t kMostNamed = 10;  // number named in the merged finding

}  // namespace

std::vector<Finding> joinAlike(const std::vector<Finding>& findings) {
  std::vector<Finding> joined;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const Finding& first = findings[i];
    const auto isAlike = [&](const Finding& other) { return other.kind == first.kind; };
    const auto begin = findings.begin() + static_cast<std::ptrdiff_t>(i);
    const auto alike =
        static_cast<std::size_t>(std::count_if(findings.begin(), findings.end(), isAlike));
    if (alike <= kMostAlike) {
      joined.push_back(first);
      continue;
    }
    if (std::any_of(findings.begin(), begin, isAlike)) continue;  // already merged
    std::vector<std::string> others;
    for (auto other = begin + 1; other != findings.end(); ++other) {
      if (isAlike(*other)) others.push_back(other->about);
    }
    joined.push_back(first);
    joined.back().found += " (likewise " + std::to_string(others.size()) +
                           " more: " + base::listed(others, kMostNamed) + ")";
  }
  return joined;
}

}  // namespace synthetic_dataset::run
