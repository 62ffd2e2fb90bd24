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

/// Some consecutive times of a run that are divided together.
struct SplitPart {
  std::int64_t instant_count = 0;
  std::optional<std::string> split = std::nullopt;  ///< of all its times; nothing: as drawn
  std::vector<std::int64_t> blocks = {};  ///< sizes of the shares' blocks; empty: by share
  std::vector<std::uint8_t> chosen = {};  ///< each time's share; empty: blocks
};

/// The split to which each of a run's times belongs: depends only on the settings, the seed and the
/// numbers of times.
class SplitPlan {
 public:
  /// @param parts  the run's times; each part is divided into blocks separately
  /// @throws Error if some parts have a split of their own and nothing specifies that of the others
  SplitPlan(const config::SplitConfig& config, std::uint64_t seed,
            const std::vector<SplitPart>& parts);

  /// The name of a time's split; empty if there are no splits.
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
  std::vector<std::uint8_t> split_of_;  ///< of each time, an index into names_; empty: no splits
};

/// Leaves out those first times of each block that are closer than the gap to the last time of the
/// block before it, so that no scene has a similar-looking neighbour in another split.
/// @return how many times remain in each share's block
[[nodiscard]] std::vector<std::int64_t> leaveOutGaps(const config::SplitConfig& config,
                                                     motion::Timeline& timeline);

/// The same for blocks that were chosen.
/// @param chosen  the share of each time; entries of omitted times are removed
void leaveOutGaps(const config::SplitConfig& config, motion::Timeline& timeline,
                  std::vector<std::uint8_t>& chosen);

}  // namespace synthetic_dataset::run
