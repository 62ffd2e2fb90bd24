#include "motion/tf/link_history.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace synthetic_dataset::motion {
namespace link_history_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr FrameId kA{1};
constexpr FrameId kB{2};

const LinkHistory& movingLink() {
  static const LinkHistory link = LinkHistory::sampledAt(
      {{Stamp(10), kA}, {Stamp(20), kA}, {Stamp(30), kB}, {Stamp(60), kB}, {Stamp(70), kA}});
  return link;
}

void expectParent(Stamp time, FrameId frame, Stamp from, Stamp until) {
  const LinkHistory::Parent parent = movingLink().parentAt(time);
  EXPECT_EQ(parent.frame, frame) << time.count();
  EXPECT_EQ(parent.validity.from, from) << time.count();
  EXPECT_EQ(parent.validity.until, until) << time.count();
}

TEST(LinkHistory, KnowsNoParentOutsideItsSamples) {
  expectParent(Stamp(9), kNoFrame, Stamp::min(), Stamp(9));
  expectParent(Stamp(71), kNoFrame, Stamp(71), Stamp::max());
}

TEST(LinkHistory, KeepsTheEarlierSamplesParentUntilTheNextSample) {
  expectParent(Stamp(10), kA, Stamp(10), Stamp(29));
  expectParent(Stamp(29), kA, Stamp(10), Stamp(29));
  expectParent(Stamp(30), kB, Stamp(30), Stamp(69));
  expectParent(Stamp(70), kA, Stamp(70), Stamp(70));
}

Duration gapLength(Stamp time) {
  const auto gap = movingLink().gapAt(time);
  return gap ? gap->length() : Duration(0);
}

TEST(LinkHistory, MeasuresTheGapAroundATime) {
  EXPECT_EQ(gapLength(Stamp(31)), Duration(30));
  EXPECT_EQ(gapLength(Stamp(59)), Duration(30));
  EXPECT_EQ(gapLength(Stamp(61)), Duration(10));
}

TEST(LinkHistory, HasNoGapAtASample) {
  EXPECT_EQ(gapLength(Stamp(10)), Duration(0));
  EXPECT_EQ(gapLength(Stamp(30)), Duration(0));
  EXPECT_EQ(gapLength(Stamp(70)), Duration(0));
}

TEST(LinkHistory, HasWhatStandsStillAtTheVerySamePlaceAllTheTime) {
  geometry_msgs::Transform here;
  here.translation.x = 0.1;
  here.translation.y = 1.0 / 3.0;
  here.rotation.x = 0.6;
  here.rotation.z = 0.48;
  here.rotation.w = 0.64;
  const LinkHistory link = LinkHistory::sampledAt({{Stamp(0), kA, here}, {Stamp(1000), kA, here}});
  for (int time = 0; time <= 1000; ++time) EXPECT_EQ(link.transformAt(Stamp(time)), here) << time;
}

TEST(LinkHistory, SaysWhetherAThingStoodStillOverAGap) {
  geometry_msgs::Transform here;
  here.rotation.w = 1.0;
  geometry_msgs::Transform nearly = here;
  nearly.translation.x = 0.0005;
  geometry_msgs::Transform there = here;
  there.translation.x = 0.5;
  const LinkHistory link = LinkHistory::sampledAt(
      {{Stamp(10), kA, here}, {Stamp(20), kA, nearly}, {Stamp(30), kA, there}});
  EXPECT_TRUE(link.gapAt(Stamp(15))->is_still);
  EXPECT_FALSE(link.gapAt(Stamp(25))->is_still);
}

TEST(LinkHistory, HasAMedianPeriod) {
  EXPECT_EQ(movingLink().medianPeriod(), Duration(10));
  EXPECT_EQ(LinkHistory::fixedTo(kB).medianPeriod(), Duration(0));
}

TEST(LinkHistory, HoldsEachValueOfAStaticLinkUntilTheNext) {
  const LinkHistory link =
      LinkHistory::heldFrom({{Stamp(10), kA}, {Stamp(20), kB}, {Stamp(30), kB}});
  EXPECT_EQ(link.parentAt(Stamp(1)).frame, kA);
  EXPECT_EQ(link.parentAt(Stamp(1)).validity.from, Stamp::min());
  EXPECT_EQ(link.parentAt(Stamp(19)).validity.until, Stamp(19));
  EXPECT_EQ(link.parentAt(Stamp(20)).frame, kB);
  EXPECT_EQ(link.parentAt(Stamp(99)).validity.until, Stamp::max());
  EXPECT_FALSE(link.gapAt(Stamp(15)).has_value());
}

TEST(LinkHistory, HoldsAStaticLinkAtAllTimes) {
  const LinkHistory link = LinkHistory::fixedTo(kB);
  EXPECT_EQ(link.parentAt(Stamp(5)).frame, kB);
  EXPECT_EQ(link.parentAt(Stamp(5)).validity.from, Stamp::min());
  EXPECT_EQ(link.parentAt(Stamp(5)).validity.until, Stamp::max());
  EXPECT_FALSE(link.gapAt(Stamp(5)).has_value());
}

TEST(LinkHistory, HasNoParentForARoot) {
  EXPECT_EQ(LinkHistory().parentAt(Stamp(5)).frame, kNoFrame);
  EXPECT_EQ(LinkHistory().parentAt(Stamp(5)).validity.until, Stamp::max());
}

TEST(LinkHistory, ListsItsParentsInOrderOfTime) {
  EXPECT_THAT(movingLink().parents(), ElementsAre(kA, kB, kA));
  EXPECT_THAT(LinkHistory::fixedTo(kB).parents(), ElementsAre(kB));
  EXPECT_THAT(LinkHistory().parents(), IsEmpty());
}

}  // namespace link_history_test
}  // namespace synthetic_dataset::motion
