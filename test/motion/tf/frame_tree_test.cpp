#include "motion/tf/frame_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace synthetic_dataset::motion {
namespace frame_tree_test {

using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAre;

/// earth (static) -> map -> odom -> base, and earth -> tower (static); base is known from 20 to 50,
/// odom from 10 to 40.
class FrameTreeTest : public ::testing::Test {
 protected:
  FrameTreeTest() {
    tree.setLink(map, LinkHistory::fixedTo(earth));
    tree.setLink(tower, LinkHistory::fixedTo(earth));
    tree.setLink(odom, LinkHistory::sampledAt({{Stamp(10), map}, {Stamp(40), map}}));
    tree.setLink(base, LinkHistory::sampledAt({{Stamp(20), odom}, {Stamp(50), odom}}));
  }

  FrameTree tree;
  FrameId earth = tree.findOrAdd("earth");
  FrameId map = tree.findOrAdd("map");
  FrameId odom = tree.findOrAdd("odom");
  FrameId base = tree.findOrAdd("base");
  FrameId tower = tree.findOrAdd("tower");
  FrameId lonely = tree.findOrAdd("lonely");
};

TEST_F(FrameTreeTest, FindsFramesByName) {
  EXPECT_EQ(tree.names().find("odom"), odom);
  EXPECT_EQ(tree.names().find("nowhere"), std::nullopt);
  EXPECT_EQ(tree.findOrAdd("odom"), odom);
  EXPECT_EQ(tree.names().of(odom), "odom");
}

TEST_F(FrameTreeTest, CrossesTheLinksBetweenAFrameAndAnAncestor) {
  EXPECT_THAT(tree.connection(map, base, Stamp(30)).links, UnorderedElementsAre(base, odom));
  EXPECT_THAT(tree.connection(base, map, Stamp(30)).links, UnorderedElementsAre(base, odom));
}

TEST_F(FrameTreeTest, CrossesTheLinksBelowTheCommonAncestorOnly) {
  EXPECT_THAT(tree.connection(tower, odom, Stamp(30)).links,
              UnorderedElementsAre(tower, map, odom));
}

TEST_F(FrameTreeTest, CrossesNothingToTheFrameItself) {
  const Connection connection = tree.connection(base, base, Stamp(0));
  EXPECT_TRUE(connection.known);
  EXPECT_THAT(connection.links, IsEmpty());
}

TEST_F(FrameTreeTest, SaysHowLongAnAnswerHolds) {
  const Connection known = tree.connection(map, base, Stamp(30));
  EXPECT_TRUE(known.known);
  EXPECT_EQ(known.validity.from, Stamp(20));
  EXPECT_EQ(known.validity.until, Stamp(40));

  const Connection unknown = tree.connection(map, base, Stamp(15));
  EXPECT_FALSE(unknown.known);
  EXPECT_EQ(unknown.validity.until, Stamp(19));
}

TEST_F(FrameTreeTest, KnowsAFrameWhileAllLinksAreKnown) {
  const std::vector<Validity> times = tree.knownTimes(map, base);
  ASSERT_THAT(times, SizeIs(1));
  EXPECT_EQ(times[0].from, Stamp(20));
  EXPECT_EQ(times[0].until, Stamp(40));
}

TEST_F(FrameTreeTest, KnowsStaticFramesAtAllTimes) {
  const std::vector<Validity> times = tree.knownTimes(map, tower);
  ASSERT_THAT(times, SizeIs(1));
  EXPECT_EQ(times[0].from, Stamp::min());
  EXPECT_EQ(times[0].until, Stamp::max());
}

TEST_F(FrameTreeTest, NeverKnowsAFrameOfAnotherTree) {
  EXPECT_THAT(tree.knownTimes(map, lonely), IsEmpty());
  EXPECT_FALSE(tree.everLinked(map, lonely));
  EXPECT_TRUE(tree.everLinked(tower, base));
}

TEST_F(FrameTreeTest, FollowsAFrameThatChangesItsParent) {
  tree.setLink(
      base, LinkHistory::sampledAt({{Stamp(0), tower}, {Stamp(20), lonely}, {Stamp(30), tower}}));
  const std::vector<Validity> times = tree.knownTimes(earth, base);
  ASSERT_THAT(times, SizeIs(2));
  EXPECT_EQ(times[0].from, Stamp(0));
  EXPECT_EQ(times[0].until, Stamp(19));
  EXPECT_EQ(times[1].from, Stamp(30));
  EXPECT_EQ(times[1].until, Stamp(30));
}

TEST_F(FrameTreeTest, MergesTimesInWhichTheWayChangesButNotTheAnswer) {
  tree.setLink(base,
               LinkHistory::sampledAt({{Stamp(0), tower}, {Stamp(20), map}, {Stamp(30), map}}));
  const std::vector<Validity> times = tree.knownTimes(earth, base);
  ASSERT_THAT(times, SizeIs(1));
  EXPECT_EQ(times[0].from, Stamp(0));
  EXPECT_EQ(times[0].until, Stamp(30));
}

TEST_F(FrameTreeTest, SurvivesALoop) {
  tree.setLink(earth, LinkHistory::fixedTo(base));
  EXPECT_FALSE(tree.connection(lonely, base, Stamp(30)).known);
  EXPECT_TRUE(tree.connection(map, base, Stamp(30)).known);
}

}  // namespace frame_tree_test
}  // namespace synthetic_dataset::motion
