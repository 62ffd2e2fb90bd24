#include "run/setup/balanced_blocks.h"

#include <algorithm>
#include <string>

#include <gmock/gmock.h>

#include "run/setup/split_plan.h"

namespace synthetic_dataset::run {
namespace balanced_blocks_test {

using testing::ElementsAre;
using testing::IsEmpty;

config::SplitConfig threeSplits() {
  config::SplitConfig config;
  config.shares = {{"train", 0.6}, {"val", 0.2}, {"test", 0.2}};
  config.by = config::SplitBy::kBalancedBlocks;
  return config;
}

/// One label of class 0, of class 1, or of none at each time: "0011..".
std::vector<ClassCounts> labels(const std::string& text) {
  std::vector<ClassCounts> all;
  for (const char c : text) all.push_back({c == '0' ? 1 : 0, c == '1' ? 1 : 0});
  return all;
}

std::string divided(const std::string& text) {
  std::string splits;
  for (const std::uint8_t share : balancedBlocks(threeSplits(), labels(text))) {
    splits += "tve"[share];
  }
  return splits;
}

TEST(BalancedBlocks, GiveEachSplitItsShareWhereLabelsAreEverywhere) {
  const std::string splits = divided("00000000000000000000");
  EXPECT_EQ(std::count(splits.begin(), splits.end(), 't'), 12);
  EXPECT_EQ(std::count(splits.begin(), splits.end(), 'v'), 4);
  EXPECT_EQ(std::count(splits.begin(), splits.end(), 'e'), 4);
}

TEST(BalancedBlocks, GiveEachSplitEachClass) {
  for (const char* text : {"0000000011110000....", "01..................01..............01..",
                           "00000000000000011111", "....0.1.....0.1.....0.1....."}) {
    const std::string splits = divided(text);
    for (const char split : {'t', 'v', 'e'}) {
      for (const char label : {'0', '1'}) {
        bool has_some = false;
        for (std::size_t i = 0; i < splits.size(); ++i) {
          has_some = has_some || (splits[i] == split && text[i] == label);
        }
        EXPECT_TRUE(has_some) << split << " lacks " << label << ": " << text << ' ' << splits;
      }
    }
  }
}

TEST(BalancedBlocks, AreFewWhereFewDo) {
  const std::string splits = divided("01010101010101010101");
  std::size_t changes = 0;
  for (std::size_t i = 1; i < splits.size(); ++i) changes += splits[i] != splits[i - 1] ? 1 : 0;
  EXPECT_LE(changes, 4U);
}

TEST(BalancedBlocks, ChooseNothingWithoutTimes) {
  EXPECT_THAT(balancedBlocks(threeSplits(), {}), IsEmpty());
}

TEST(BalancedBlocks, KeepTheirGaps) {
  motion::Timeline timeline;
  for (int i = 0; i < 8; ++i) timeline.stamps.emplace_back(std::chrono::seconds(i));
  config::SplitConfig config = threeSplits();
  config.gap = 2.0;
  std::vector<std::uint8_t> chosen = {0, 0, 1, 1, 1, 0, 0, 0};
  leaveOutGaps(config, timeline, chosen);
  EXPECT_THAT(chosen, ElementsAre(0, 0, 1, 1, 0, 0));
  EXPECT_EQ(timeline.left_out_split, 2);
  EXPECT_EQ(timeline.stamps[2], Stamp(std::chrono::seconds(3)));
}

}  // namespace balanced_blocks_test
}  // namespace synthetic_dataset::run
