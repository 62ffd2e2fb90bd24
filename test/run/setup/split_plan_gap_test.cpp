#include <gmock/gmock.h>

#include "run/setup/split_plan.h"

namespace synthetic_dataset::run {
namespace split_gap_test {

using testing::ElementsAre;

config::SplitConfig halves(double gap) {
  config::SplitConfig config;
  config.shares = {{"train", 0.5}, {"val", 0.25}, {"test", 0.25}};
  config.gap = gap;
  return config;
}

/// A timeline of this many times, a second apart.
motion::Timeline seconds(int count) {
  motion::Timeline timeline;
  for (int i = 0; i < count; ++i) timeline.stamps.emplace_back(std::chrono::seconds(i));
  return timeline;
}

TEST(SplitGap, LeavesOutWhatIsNearTheBlockBefore) {
  motion::Timeline timeline = seconds(16);  // blocks from 0, 8 and 12 s on
  EXPECT_THAT(leaveOutGaps(halves(3.0), timeline), ElementsAre(8, 2, 2));
  EXPECT_EQ(timeline.left_out_split, 4);
  const SplitPlan plan(halves(3.0), 0, {{12, std::nullopt, {8, 2, 2}}});
  std::string all;
  for (int i = 0; i < 12; ++i) all += plan.at(i).substr(0, 1);
  EXPECT_EQ(all, "ttttttttvvtt");
  EXPECT_EQ(timeline.stamps[7], Stamp(std::chrono::seconds(7)));
  EXPECT_EQ(timeline.stamps[8], Stamp(std::chrono::seconds(10)));
  EXPECT_EQ(timeline.stamps[10], Stamp(std::chrono::seconds(14)));
}

TEST(SplitGap, KeepsTheJitterOfWhatStays) {
  motion::Timeline timeline = seconds(4);
  for (int i = 0; i < 4; ++i) timeline.jitter.emplace_back(i);
  EXPECT_THAT(
      leaveOutGaps({{{"train", 0.5}, {"val", 0.5}}, config::SplitBy::kBlocks, 2.0}, timeline),
      ElementsAre(2, 1));
  EXPECT_THAT(timeline.jitter, ElementsAre(Duration(0), Duration(1), Duration(3)));
}

TEST(SplitGap, MayLeaveNothingOfABlock) {
  motion::Timeline timeline = seconds(4);
  EXPECT_THAT(leaveOutGaps(halves(60.0), timeline), ElementsAre(2, 0, 0));
}

}  // namespace split_gap_test
}  // namespace synthetic_dataset::run
