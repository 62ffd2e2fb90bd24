#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/config.h"
#include "motion/timeline.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::run {

/// The end (exclusive) of each of the shares' blocks of times.
[[nodiscard]] std::vector<std::int64_t> blockEnds(const config::SplitConfig& config,
                                                  std::int64_t instant_count);

/// Some of a run's times, one after another, that are divided as a whole.
struct SplitPart {
  std::int64_t instant_count = 0;
  std::optional<std::string> split = std::nullopt;  ///< of all of them; nothing: as drawn
  std::vector<std::int64_t> blocks =
      {};  ///< the number in each share's block; empty: by the shares
  std::vector<std::uint8_t> chosen = {};  ///< the share of each time; empty: in blocks
};

/// Which split each of a run's times belongs to: a function of the settings, the seed and the
/// numbers of times alone.
class SplitPlan {
 public:
  /// @param parts  the run's times; blocks are taken from each part on its own
  /// @throws Error where some parts have a split of their own, and nothing says which the others
  ///     have
  SplitPlan(const config::SplitConfig& config, std::uint64_t seed,
            const std::vector<SplitPart>& parts);

  /// The name of a time's split; empty where there are none.
  [[nodiscard]] const std::string& at(std::int64_t instant) const;

  /// The splits with their numbers of scenes.
  /// @param camera_count  scenes at each time
  [[nodiscard]] std::vector<SplitInfo> splits(std::size_t camera_count) const;

 private:
  void nameSplits(const config::SplitConfig& config, const std::vector<SplitPart>& parts);
  [[nodiscard]] std::uint8_t numberOf(const std::string& name) const;

  /// The splits of a part's times, block by block.
  [[nodiscard]] std::vector<std::uint8_t> blocks(const config::SplitConfig& config,
                                                 const SplitPart& part) const;

  std::vector<std::string> names_;
  std::vector<std::uint8_t> split_of_;  ///< of each time, a place in names_; empty without splits
};

/// Leaves out the first times of each block that are nearer than the gap to the last time of the
/// block before it, so that no scene has a neighbour in another split that looks like it.
/// @return how many times each of the shares' blocks has now
[[nodiscard]] std::vector<std::int64_t> leaveOutGaps(const config::SplitConfig& config,
                                                     motion::Timeline& timeline);

/// The same where blocks are chosen.
/// @param chosen  the share of each time; those that are left out go from it, too
void leaveOutGaps(const config::SplitConfig& config, motion::Timeline& timeline,
                  std::vector<std::uint8_t>& chosen);

}  // namespace synthetic_dataset::run
