#include "run/setup/split_plan.h"

#include <gmock/gmock.h>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::run {
namespace split_plan_test {

config::SplitConfig eightOneOne(config::SplitBy by) {
  return {{{"train", 0.8}, {"val", 0.1}, {"test", 0.1}}, by};
}

TEST(SplitPlan, HasNoNamesWithoutSplits) {
  const SplitPlan plan({}, 0, {{10}});
  EXPECT_EQ(plan.at(3), "");
  EXPECT_TRUE(plan.splits(1).empty());
}

TEST(SplitPlan, BlocksFollowOneAnother) {
  const SplitPlan plan(eightOneOne(config::SplitBy::kBlocks), 0, {{20}});
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(plan.at(i), i < 16 ? "train" : i < 18 ? "val" : "test") << i;
  }
}

TEST(SplitPlan, CountsScenesOfAllCameras) {
  const auto splits = SplitPlan(eightOneOne(config::SplitBy::kBlocks), 0, {{20}}).splits(3);
  ASSERT_EQ(splits.size(), 3U);
  EXPECT_EQ(splits[0].scene_count, 48);
  EXPECT_EQ(splits[1].scene_count, 6);
  EXPECT_EQ(splits[2].scene_count, 6);
}

TEST(SplitPlan, EverySceneHasASplitWhateverTheNumber) {
  for (int count = 0; count < 30; ++count) {
    const SplitPlan plan({{{"train", 1.0 / 3}, {"val", 1.0 / 3}, {"test", 1.0 / 3}}}, 0, {{count}});
    std::int64_t sum = 0;
    for (const SplitInfo& split : plan.splits(1)) sum += split.scene_count;
    EXPECT_EQ(sum, count);
    for (int i = 0; i < count; ++i) EXPECT_FALSE(plan.at(i).empty());
  }
}

TEST(SplitPlan, DrawsKeepTheCountsAndMixTheScenes) {
  const SplitPlan plan(eightOneOne(config::SplitBy::kScenes), 7, {{1000}});
  const auto splits = plan.splits(1);
  EXPECT_EQ(splits[0].scene_count, 800);
  EXPECT_EQ(splits[1].scene_count, 100);
  // In blocks, the first half would have none of them; drawn, 50 +- 5 (one standard deviation).
  int in_first_half = 0;
  for (int i = 0; i < 500; ++i) in_first_half += plan.at(i) == "val" ? 1 : 0;
  EXPECT_GT(in_first_half, 25);
  EXPECT_LT(in_first_half, 75);
}

TEST(SplitPlan, DrawsFollowTheSeedAlone) {
  const auto drawn = [](std::uint64_t seed) {
    const SplitPlan plan(eightOneOne(config::SplitBy::kScenes), seed, {{200}});
    std::string all;
    for (int i = 0; i < 200; ++i) all += plan.at(i)[0];
    return all;
  };
  EXPECT_EQ(drawn(1), drawn(1));
  EXPECT_NE(drawn(1), drawn(2));
}

TEST(SplitPlan, TakesBlocksOfEachPart) {
  const SplitPlan plan(eightOneOne(config::SplitBy::kBlocks), 0, {{10}, {20}});
  std::string all;
  for (int i = 0; i < 30; ++i) all += plan.at(i).substr(0, 2);
  const std::string ten = "trtrtrtrtrtrtrtrvate";
  const std::string twenty = "trtrtrtrtrtrtrtrtrtrtrtrtrtrtrtrvavatete";
  EXPECT_EQ(all, ten + twenty);
}

TEST(SplitPlan, DrawsOtherwiseForEachPart) {
  const SplitPlan plan(eightOneOne(config::SplitBy::kScenes), 7, {{200}, {200}});
  EXPECT_EQ(plan.splits(1)[1].scene_count, 40);
  int alike = 0;
  for (int i = 0; i < 200; ++i) alike += plan.at(i) == plan.at(200 + i) ? 1 : 0;
  EXPECT_LT(alike, 190);  // independent ones agree in 132 of 200, give or take 7
}

TEST(SplitPlan, APartMayBeInOneSplitAsAWhole) {
  const SplitPlan plan({{{"train", 1.0}}}, 0, {{10}, {5, "test"}});
  for (int i = 0; i < 15; ++i) EXPECT_EQ(plan.at(i), i < 10 ? "train" : "test") << i;
  const auto splits = plan.splits(2);
  ASSERT_EQ(splits.size(), 2U);
  EXPECT_EQ(splits[1].name, "test");
  EXPECT_EQ(splits[1].scene_count, 10);
}

TEST(SplitPlan, NeedsNoSharesWhereEveryPartHasItsSplit) {
  const SplitPlan plan({}, 0, {{3, "val"}, {4, "train"}});
  const auto splits = plan.splits(1);
  ASSERT_EQ(splits.size(), 2U);
  EXPECT_EQ(splits[0].name, "train");  // in the order that all have
  EXPECT_EQ(plan.at(0), "val");
}

TEST(SplitPlan, RefusesToGuessWhereTheOthersAre) {
  try {
    const SplitPlan plan({}, 0, {{3, "val"}, {4}});
    FAIL() << "it guessed";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("split: missing; some of the motions"));
  }
}

}  // namespace split_plan_test
}  // namespace synthetic_dataset::run
