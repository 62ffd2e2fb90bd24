#include "split_plan.h"

#include <gtest/gtest.h>

namespace synthetic_dataset {
namespace {

config::SplitConfig eightOneOne(config::SplitBy by) {
  return {{{"train", 0.8}, {"val", 0.1}, {"test", 0.1}}, by};
}

TEST(SplitPlan, HasNoNamesWithoutSplits) {
  const SplitPlan plan({}, 0, 10);
  EXPECT_EQ(plan.at(3), "");
  EXPECT_TRUE(plan.splits(1).empty());
}

TEST(SplitPlan, BlocksFollowOneAnother) {
  const SplitPlan plan(eightOneOne(config::SplitBy::kBlocks), 0, 20);
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(plan.at(i), i < 16 ? "train" : i < 18 ? "val" : "test") << i;
  }
}

TEST(SplitPlan, CountsScenesOfAllCameras) {
  const auto splits = SplitPlan(eightOneOne(config::SplitBy::kBlocks), 0, 20).splits(3);
  ASSERT_EQ(splits.size(), 3U);
  EXPECT_EQ(splits[0].scene_count, 48);
  EXPECT_EQ(splits[1].scene_count, 6);
  EXPECT_EQ(splits[2].scene_count, 6);
}

TEST(SplitPlan, EverySceneHasASplitWhateverTheNumber) {
  for (int count = 0; count < 30; ++count) {
    const SplitPlan plan({{{"train", 1.0 / 3}, {"val", 1.0 / 3}, {"test", 1.0 / 3}}}, 0, count);
    std::int64_t sum = 0;
    for (const SplitInfo& split : plan.splits(1)) sum += split.scene_count;
    EXPECT_EQ(sum, count);
    for (int i = 0; i < count; ++i) EXPECT_FALSE(plan.at(i).empty());
  }
}

TEST(SplitPlan, DrawsKeepTheCountsAndMixTheScenes) {
  const SplitPlan plan(eightOneOne(config::SplitBy::kScenes), 7, 1000);
  const auto splits = plan.splits(1);
  EXPECT_EQ(splits[0].scene_count, 800);
  EXPECT_EQ(splits[1].scene_count, 100);
  // In blocks, the first half would have none of them. Drawn, 50 +- 5 (one standard deviation).
  int in_first_half = 0;
  for (int i = 0; i < 500; ++i) in_first_half += plan.at(i) == "val" ? 1 : 0;
  EXPECT_GT(in_first_half, 25);
  EXPECT_LT(in_first_half, 75);
}

TEST(SplitPlan, DrawsFollowTheSeedAlone) {
  const auto drawn = [](std::uint64_t seed) {
    const SplitPlan plan(eightOneOne(config::SplitBy::kScenes), seed, 200);
    std::string all;
    for (int i = 0; i < 200; ++i) all += plan.at(i)[0];
    return all;
  };
  EXPECT_EQ(drawn(1), drawn(1));
  EXPECT_NE(drawn(1), drawn(2));
}

}  // namespace
}  // namespace synthetic_dataset
