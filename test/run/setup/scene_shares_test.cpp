#include "run/setup/scene_shares.h"

#include <numeric>

#include <gmock/gmock.h>

#include "support/error_messages.h"

namespace synthetic_dataset::run {
namespace scene_shares_test {

using ::testing::ElementsAre;

/// The errors of motions that cannot share.
std::vector<std::string> errorsOf(const std::vector<SharingMotion>& motions,
                                  std::optional<std::int64_t> total) {
  return test::messagesOf([&] { static_cast<void>(sharesOf(motions, total)); });
}

TEST(SharesOf, AreInProportionToTheWeights) {
  EXPECT_THAT(sharesOf({{"a", 2, 100}, {"b", 1, 100}, {"c", 1, 100}}, 40), ElementsAre(20, 10, 10));
  EXPECT_THAT(sharesOf({{"a", 0.5, 100}, {"b", 1.5, 100}}, 20), ElementsAre(5, 15));
}

TEST(SharesOf, GiveTheRestToTheLargestRemainders) {
  EXPECT_THAT(sharesOf({{"a", 5.2, 9}, {"b", 3.5, 9}, {"c", 1.3, 9}}, 10), ElementsAre(5, 4, 1));
  EXPECT_THAT(sharesOf({{"a", 5.1, 9}, {"b", 3.1, 9}, {"c", 1.8, 9}}, 10), ElementsAre(5, 3, 2));
}

TEST(SharesOf, GiveAllScenesAway) {
  for (std::int64_t total = 3; total < 200; ++total) {
    const auto counts = sharesOf({{"a", 1, 999}, {"b", 1, 999}, {"c", 1, 999}}, total);
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::int64_t{0}), total);
    EXPECT_LE(counts.front() - counts.back(), 1);
  }
}

TEST(SharesOf, GiveTheFirstOnesMoreWhereRemaindersAreEqual) {
  EXPECT_THAT(sharesOf({{"a", 1, 9}, {"b", 1, 9}, {"c", 1, 9}}, 4), ElementsAre(2, 1, 1));
}

TEST(SharesOf, AreTheMostForWhichAllHaveEnoughWithoutATotal) {
  EXPECT_THAT(sharesOf({{"a", 1, 10}, {"b", 2, 100}}, std::nullopt), ElementsAre(10, 20));
  EXPECT_THAT(sharesOf({{"a", 1, 100}, {"b", 2, 20}}, std::nullopt), ElementsAre(10, 20));
  EXPECT_THAT(sharesOf({{"a", 1, 7}}, std::nullopt), ElementsAre(7));
  // Tenths are not exact in binary, but not one scene is lost by that.
  EXPECT_THAT(sharesOf({{"a", 0.1, 10}, {"b", 0.2, 20}, {"c", 0.3, 30}}, std::nullopt),
              ElementsAre(10, 20, 30));
}

TEST(SharesOf, NeverAskForMoreThanThereIsWithoutATotal) {
  for (std::int64_t a = 1; a < 12; ++a) {
    for (std::int64_t b = 1; b < 12; ++b) {
      const auto counts = sharesOf({{"a", 2, a + 2}, {"b", 3, b + 2}, {"c", 3, 9}}, std::nullopt);
      EXPECT_LE(counts[0], a + 2);
      EXPECT_LE(counts[1], b + 2);
      EXPECT_LE(counts[2], 9);
    }
  }
}

TEST(SharesOf, NameAMotionThatHasTooFew) {
  EXPECT_THAT(
      errorsOf({{"motions/0", 3, 10}, {"motions/1", 1, 100}}, 40),
      ElementsAre("motions/0/weight: found 3.0 of 4.0 in all, which is 30 of the 40 scenes; "
                  "this motion has 10 (fewer scenes in all, a smaller weight or more "
                  "scenes of this motion help)"));
}

TEST(SharesOf, NameAMotionThatWouldGiveNone) {
  EXPECT_THAT(errorsOf({{"motions/0", 1, 10}, {"motions/1", 100, 100}}, 10),
              ElementsAre("motions/0/weight: found 1.0 of 101.0 in all, which is less than one "
                          "scene; it should be larger, or scenes should"));
  EXPECT_THAT(errorsOf({{"motions/0", 1, 10}, {"motions/1", 100, 10}}, std::nullopt),
              ElementsAre("motions/0/weight: found 1.0 of 101.0 in all, which is less than one "
                          "scene; it should be larger"));
}

TEST(SharesOf, NameAllThatHaveTooFew) {
  EXPECT_EQ(errorsOf({{"a", 1, 1}, {"b", 1, 100}, {"c", 1, 2}}, 30).size(), 2U);
}

}  // namespace scene_shares_test
}  // namespace synthetic_dataset::run
