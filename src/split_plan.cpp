#include "split_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "random/random_seed.h"

namespace synthetic_dataset {

SplitPlan::SplitPlan(const config::SplitConfig& config, std::uint64_t seed,
                     std::int64_t instant_count) {
  double share_so_far = 0.0;
  for (const auto& [name, share] : config.shares) {
    share_so_far += share;
    const double end = std::round(share_so_far * static_cast<double>(instant_count));
    split_of_.resize(static_cast<std::size_t>(end), static_cast<std::uint8_t>(names_.size()));
    names_.push_back(name);
  }
  if (names_.empty()) return;
  split_of_.resize(static_cast<std::size_t>(instant_count),
                   static_cast<std::uint8_t>(names_.size() - 1));
  if (config.by == config::SplitBy::kBlocks) return;
  // Fisher and Yates; std::shuffle differs from library to library. The numbers are so much larger
  // than the counts that the remainder is as good as uniform.
  for (std::size_t i = split_of_.size(); i > 1; --i) {
    const std::uint64_t draw = random::randomSeed(seed, static_cast<std::int64_t>(i), "split");
    std::swap(split_of_[i - 1], split_of_[draw % i]);
  }
}

const std::string& SplitPlan::at(std::int64_t instant) const {
  static const std::string kNone;
  return split_of_.empty() ? kNone : names_[split_of_[static_cast<std::size_t>(instant)]];
}

std::vector<SplitInfo> SplitPlan::splits(std::size_t camera_count) const {
  std::vector<SplitInfo> splits;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const auto count = std::count(split_of_.begin(), split_of_.end(), static_cast<std::uint8_t>(i));
    splits.push_back({names_[i], count * static_cast<std::int64_t>(camera_count)});
  }
  return splits;
}

}  // namespace synthetic_dataset
