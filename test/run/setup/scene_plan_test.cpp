#include "run/setup/scene_plan.h"

#include <algorithm>

#include <gmock/gmock.h>

namespace synthetic_dataset::run {
namespace scene_plan_test {

using ::testing::ElementsAre;

/// Times 0, 1, 2, ... [ns].
motion::Timeline timeline(std::int64_t count) {
  motion::Timeline timeline;
  for (std::int64_t i = 0; i < count; ++i) timeline.stamps.emplace_back(i);
  return timeline;
}

/// Which of the times stay.
std::vector<std::int64_t> kept(std::int64_t all, std::int64_t count) {
  motion::Timeline thinned = timeline(all);
  thinOut(thinned, count);
  std::vector<std::int64_t> kept;
  for (const Stamp stamp : thinned.stamps) kept.push_back(stamp.count());
  return kept;
}

TEST(ThinOut, TakesEachTimeWhereAllAreAskedFor) {
  EXPECT_THAT(kept(4, 4), ElementsAre(0, 1, 2, 3));
}

TEST(ThinOut, SpreadsWhatItKeepsOverAll) {
  EXPECT_THAT(kept(10, 5), ElementsAre(0, 2, 4, 6, 8));
  EXPECT_THAT(kept(10, 4), ElementsAre(0, 2, 5, 7));
  EXPECT_THAT(kept(10, 1), ElementsAre(0));
}

TEST(ThinOut, LeavesNoGapThatIsMuchLongerThanOthers) {
  for (std::int64_t count = 1; count <= 60; ++count) {
    std::vector<std::int64_t> times = kept(60, count);
    ASSERT_EQ(times.size(), static_cast<std::size_t>(count));
    times.push_back(60);
    for (std::size_t i = 1; i < times.size(); ++i) {
      const std::int64_t gap = times[i] - times[i - 1];
      EXPECT_GE(gap, 60 / count);
      EXPECT_LE(gap, 60 / count + 1);
    }
  }
}

}  // namespace scene_plan_test
}  // namespace synthetic_dataset::run
