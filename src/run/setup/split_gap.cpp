#include "run/setup/split_gap.h"

#include <cstddef>
#include <optional>

#include "base/seconds.h"
#include "run/setup/split_plan.h"

namespace synthetic_dataset::run {

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

}  // namespace synthetic_dataset::run
