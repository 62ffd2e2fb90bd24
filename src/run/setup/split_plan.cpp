#include "run/setup/split_plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>

#include "base/random/random_seed.h"
#include "base/seconds.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::run {
namespace {

/// Fisher-Yates shuffle; std::shuffle differs between standard libraries. The random numbers are so
/// much larger than the counts that their remainder is practically uniform.
/// @param drawn  how many numbers earlier parts have drawn
void shuffle(std::vector<std::uint8_t>& splits, std::uint64_t seed, std::uint64_t drawn) {
  for (std::size_t i = splits.size(); i > 1; --i) {
    const auto place = static_cast<std::int64_t>(drawn + i);
    const std::uint64_t draw = base::randomSeed(seed, place, "split");
    std::swap(splits[i - 1], splits[draw % i]);
  }
}

}  // namespace

std::vector<std::int64_t> blockEnds(const config::SplitConfig& config, std::int64_t instant_count) {
  std::vector<std::int64_t> ends;
  double share_so_far = 0.0;
  for (const auto& [name, share] : config.shares) {
    share_so_far += share;
    ends.push_back(std::llround(share_so_far * static_cast<double>(instant_count)));
  }
  if (!ends.empty()) ends.back() = instant_count;
  return ends;
}

SplitPlan::SplitPlan(const config::SplitConfig& config, std::uint64_t seed,
                     const std::vector<SplitPart>& parts) {
  nameSplits(config, parts);
  if (names_.empty()) return;
  std::uint64_t drawn = 0;  // so far, so that each part uses different draws
  for (const SplitPart& part : parts) {
    const auto count = static_cast<std::size_t>(part.instant_count);
    std::vector<std::uint8_t> splits =
        part.split ? std::vector<std::uint8_t>(count, numberOf(*part.split)) : blocks(config, part);
    if (!part.split && config.by == config::SplitBy::kScenes) shuffle(splits, seed, drawn);
    drawn += count;
    split_of_.insert(split_of_.end(), splits.begin(), splits.end());
  }
}

void SplitPlan::nameSplits(const config::SplitConfig& config, const std::vector<SplitPart>& parts) {
  std::set<std::string> named;
  bool all_have_one = true;
  for (const auto& [name, share] : config.shares) named.insert(name);
  for (const SplitPart& part : parts) {
    if (part.split) named.insert(*part.split);
    all_have_one = all_have_one && part.split;
  }
  if (!named.empty() && config.shares.empty() && !all_have_one) {
    throw Error(
        "split: missing; some of the motions have a split of their own, and it should say "
        "which one the others' scenes belong to");
  }
  for (const char* name : {"train", "val", "test"}) {
    if (named.count(name) != 0) names_.emplace_back(name);
  }
}

std::uint8_t SplitPlan::numberOf(const std::string& name) const {
  return static_cast<std::uint8_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
}

std::vector<std::uint8_t> SplitPlan::blocks(const config::SplitConfig& config,
                                            const SplitPart& part) const {
  if (!part.chosen.empty()) {
    std::vector<std::uint8_t> splits;
    for (const std::uint8_t share : part.chosen) {
      splits.push_back(numberOf(config.shares[share].first));
    }
    return splits;
  }
  std::vector<std::int64_t> ends = blockEnds(config, part.instant_count);
  std::int64_t end = 0;
  for (std::size_t i = 0; i < part.blocks.size(); ++i) ends.at(i) = end += part.blocks[i];
  std::vector<std::uint8_t> splits;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    splits.resize(static_cast<std::size_t>(ends[i]), numberOf(config.shares[i].first));
  }
  return splits;
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

std::vector<std::int64_t> leaveOutGaps(const config::SplitConfig& config,
                                       motion::Timeline& timeline) {
  const Duration gap = base::fromSeconds(config.gap);
  const motion::Timeline all = timeline;
  timeline.stamps.clear();
  timeline.jitter.clear();
  std::vector<std::int64_t> counts;
  std::optional<Stamp> last;  // of the blocks before
  std::size_t i = 0;
  for (const std::int64_t end : blockEnds(config, static_cast<std::int64_t>(all.stamps.size()))) {
    const std::size_t first = timeline.stamps.size();
    for (; i < static_cast<std::size_t>(end); ++i) {
      if (last && all.stamps[i] - *last < gap) continue;
      timeline.stamps.push_back(all.stamps[i]);
      if (!all.jitter.empty()) timeline.jitter.push_back(all.jitter[i]);
    }
    counts.push_back(static_cast<std::int64_t>(timeline.stamps.size() - first));
    if (!timeline.stamps.empty()) last = timeline.stamps.back();
  }
  timeline.left_out_split = static_cast<std::int64_t>(all.stamps.size() - timeline.stamps.size());
  return counts;
}

void leaveOutGaps(const config::SplitConfig& config, motion::Timeline& timeline,
                  std::vector<std::uint8_t>& chosen) {
  const Duration gap = base::fromSeconds(config.gap);
  const motion::Timeline all = timeline;
  const std::vector<std::uint8_t> all_chosen = std::exchange(chosen, {});
  timeline.stamps.clear();
  timeline.jitter.clear();
  std::optional<Stamp> last;  // of the block before
  for (std::size_t i = 0; i < all.stamps.size(); ++i) {
    const bool begins = i > 0 && all_chosen[i] != all_chosen[i - 1];
    if (begins && !timeline.stamps.empty()) last = timeline.stamps.back();
    if (last && all.stamps[i] - *last < gap) continue;
    timeline.stamps.push_back(all.stamps[i]);
    if (!all.jitter.empty()) timeline.jitter.push_back(all.jitter[i]);
    chosen.push_back(all_chosen[i]);
  }
  timeline.left_out_split = static_cast<std::int64_t>(all.stamps.size() - timeline.stamps.size());
}

}  // namespace synthetic_dataset::run
