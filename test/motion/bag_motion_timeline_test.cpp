#include <chrono>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/recorded.h"
#include "support/error_messages.h"

namespace synthetic_dataset::motion {
namespace bag_motion_timeline_test {

using test::BagBuilder;
using test::milliseconds;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

TEST(Timeline, GoesFromTheRecordingsStartAndStopsBeforeItsEnd) {
  const BagMotion motion =
      recorded([](BagBuilder& bag) { moveAlongX(bag, "map", "alpha", 1000, 2000); });
  const Timeline timeline = motion.timeline({"alpha"}, everyMilliseconds(250));
  EXPECT_THAT(timeline.stamps, ElementsAre(milliseconds(1000), milliseconds(1250),
                                           milliseconds(1500), milliseconds(1750)));
  EXPECT_EQ(timeline.left_out_unknown, 0);
  EXPECT_EQ(timeline.left_out_gap, 0);
}

TEST(Timeline, IsAtTheTimesThatAreGiven) {
  const BagMotion motion =
      recorded([](BagBuilder& bag) { moveAlongX(bag, "map", "alpha", 1000, 2000); });
  TimelineOptions options = everyMilliseconds(250);
  options.stamps = {milliseconds(900), milliseconds(1003), milliseconds(1500), milliseconds(2000),
                    milliseconds(2100)};
  const Timeline timeline = motion.timeline({"alpha"}, options);
  EXPECT_THAT(timeline.stamps,
              ElementsAre(milliseconds(1003), milliseconds(1500), milliseconds(2000)));
  EXPECT_EQ(timeline.left_out_unknown, 0) << "those are outside of the recording";
}

TEST(Timeline, SaysWhenNoneOfTheGivenTimesIsInTheWindow) {
  const BagMotion motion =
      recorded([](BagBuilder& bag) { moveAlongX(bag, "map", "alpha", 1000, 2000); });
  TimelineOptions options = everyMilliseconds(250);
  options.stamps = {milliseconds(2100)};
  EXPECT_THAT(test::messagesOf([&] { (void)motion.timeline({"alpha"}, options); }),
              ElementsAre(HasSubstr("no picture is in the window: there are 1, from "
                                    "2.100000000 s")));
}

TEST(Timeline, StartsOnItsGridWhenTheLastFrameAppears) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    moveAlongX(bag, "map", "alpha", 1000, 3000);
    moveAlongX(bag, "map", "bravo", 1600, 3000);
  });
  const Timeline timeline = motion.timeline({"alpha", "bravo"}, everyMilliseconds(500));
  EXPECT_THAT(timeline.stamps, ElementsAre(milliseconds(2000), milliseconds(2500)));
}

TEST(Timeline, FindsItsEndInStepsBackFromTheRecordingsEnd) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    moveAlongX(bag, "map", "alpha", 1000, 2700);
    bag.say("/chatter", milliseconds(3300));
  });
  // Going back by way of 3300 and 2800, 2300 is the first known time: scenes end before it.
  const Timeline timeline = motion.timeline({"alpha"}, everyMilliseconds(500));
  EXPECT_THAT(timeline.stamps,
              ElementsAre(milliseconds(1000), milliseconds(1500), milliseconds(2000)));
}

TEST(Timeline, MakesNoSceneAtTheEndItself) {
  const BagMotion motion =
      recorded([](BagBuilder& bag) { moveAlongX(bag, "map", "alpha", 1000, 2000); });
  EXPECT_THAT(motion.timeline({"alpha"}, everyMilliseconds(500)).stamps,
              ElementsAre(milliseconds(1000), milliseconds(1500)));
}

TEST(Timeline, DoesNotDriftWithAPeriodThatWasCut) {
  const BagMotion motion =
      recorded([](BagBuilder& bag) { moveAlongX(bag, "map", "alpha", 1000, 101000, 1000); });
  TimelineOptions options;
  options.period = periodOf(30.0);
  const Timeline timeline = motion.timeline({"alpha"}, options);
  ASSERT_THAT(timeline.stamps, SizeIs(3001));  // 100 s / 33333333 ns, rounded up
  EXPECT_EQ(timeline.stamps[3000], Stamp(1000000000 + 3000 * 33333333LL));
}

TEST(Timeline, KeepsToThePartThatIsAskedFor) {
  const BagMotion motion =
      recorded([](BagBuilder& bag) { moveAlongX(bag, "map", "alpha", 1000, 9000); });
  TimelineOptions options = everyMilliseconds(500);
  options.start_offset = milliseconds(1200);
  options.duration = milliseconds(1000);
  EXPECT_THAT(motion.timeline({"alpha"}, options).stamps,
              ElementsAre(milliseconds(2200), milliseconds(2700)));
}

TEST(Timeline, EndsWithTheRecordingWhenTheDurationIsLonger) {
  const BagMotion motion =
      recorded([](BagBuilder& bag) { moveAlongX(bag, "map", "alpha", 1000, 2000); });
  TimelineOptions options = everyMilliseconds(500);
  options.duration = milliseconds(5000);
  const Timeline timeline = motion.timeline({"alpha"}, options);
  EXPECT_THAT(timeline.stamps, SizeIs(2));
  EXPECT_THAT(timeline.diagnostics.messages(base::Severity::kNote),
              ElementsAre(AllOf(HasSubstr("duration: found 5.000"), HasSubstr("has 1.000"),
                                HasSubstr("all of it is used"))));
  options.duration = Duration::max();
  EXPECT_THAT(motion.timeline({"alpha"}, options).stamps, SizeIs(2));
}

/// Delays each scene by 10 ms times its place on the grid.
TimelineOptions laterByPlace(std::int64_t period) {
  TimelineOptions options = everyMilliseconds(period);
  options.jitter = [](std::int64_t place) { return milliseconds(10 * place); };
  return options;
}

TEST(Timeline, MovesEachSceneByWhatItsPlaceOnTheGridSays) {
  const auto jittered = [](std::int64_t first_of_bravo) {
    const BagMotion motion = recorded([&](BagBuilder& bag) {
      moveAlongX(bag, "map", "alpha", 1000, 3000);
      moveAlongX(bag, "map", "bravo", first_of_bravo, 3000);
    });
    return motion.timeline({"alpha", "bravo"}, laterByPlace(500));
  };
  EXPECT_THAT(jittered(1000).stamps, ElementsAre(milliseconds(1000), milliseconds(1510),
                                                 milliseconds(2020), milliseconds(2530)));
  EXPECT_THAT(jittered(1400).stamps,
              ElementsAre(milliseconds(1510), milliseconds(2020), milliseconds(2530)))
      << "a scene that is not there moves no other";
  EXPECT_THAT(jittered(1400).jitter,
              ElementsAre(milliseconds(10), milliseconds(20), milliseconds(30)));
}

TEST(Timeline, LeavesOutScenesThatAreMovedToWhereATransformIsNotKnown) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    moveAlongX(bag, "map", "alpha", 1000, 2000);
    moveAlongX(bag, "map", "bravo", 1000, 1400);
    bag.move("elsewhere", "bravo", milliseconds(1510));
    moveAlongX(bag, "map", "bravo", 1600, 2000);
  });
  TimelineOptions options = everyMilliseconds(250);
  options.jitter = [](std::int64_t place) { return milliseconds(place == 0 ? -5 : 12); };
  const Timeline timeline = motion.timeline({"alpha", "bravo"}, options);
  EXPECT_THAT(timeline.stamps, ElementsAre(milliseconds(1262), milliseconds(1762)));
  EXPECT_THAT(timeline.jitter, SizeIs(2));
  EXPECT_EQ(timeline.left_out_unknown, 2) << "before the recording, and at 1512";
}

TEST(Timeline, LeavesOutScenesAtWhichATransformIsNotKnown) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    moveAlongX(bag, "map", "alpha", 1000, 1400);
    bag.move("elsewhere", "alpha", milliseconds(1500));
    moveAlongX(bag, "map", "alpha", 1700, 2000);
  });
  const Timeline timeline = motion.timeline({"alpha"}, everyMilliseconds(100));
  EXPECT_THAT(timeline.stamps, SizeIs(8));  // ten, without 1500 and 1600
  EXPECT_EQ(timeline.left_out_unknown, 2);
}

TEST(Timeline, LeavesOutScenesAcrossLongGaps) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    bag.fix("alpha", "mast", milliseconds(1000));
    moveAlongX(bag, "map", "alpha", 1000, 1500);
    moveAlongX(bag, "map", "alpha", 1900, 2200);
  });
  TimelineOptions options = everyMilliseconds(100);
  options.max_tf_gap = milliseconds(100);
  const Timeline timeline = motion.timeline({"mast"}, options);
  EXPECT_EQ(timeline.left_out_gap, 3);  // 1600, 1700, 1800: 1500 and 1900 are samples
  EXPECT_THAT(timeline.stamps, SizeIs(9));
  options.max_tf_gap = milliseconds(400);
  EXPECT_EQ(motion.timeline({"mast"}, options).left_out_gap, 0);
}

/// A second at 10 Hz, nothing for an hour, a second elsewhere.
Timeline acrossAnHour(double x_after, const TimelineOptions& options) {
  constexpr std::int64_t kHour = 3600000;  // [ms]
  const BagMotion motion = recorded([&](BagBuilder& bag) {
    for (int i = 0; i <= 10; ++i) bag.move("map", "alpha", milliseconds(1000 + 100 * i));
    for (int i = 0; i <= 10; ++i) {
      bag.move("map", "alpha", milliseconds(kHour + 100 * i), test::poseAt(x_after, 0, 0));
    }
  });
  return motion.timeline({"alpha"}, options);
}

TEST(Timeline, LeavesOutScenesInAHoleUnlessAskedForThem) {
  const Timeline timeline = acrossAnHour(5.0, everyMilliseconds(500));
  EXPECT_THAT(timeline.stamps, SizeIs(5)) << "three before the hole, two after it";
  EXPECT_THAT(timeline.diagnostics.messages(base::Severity::kWarning),
              ElementsAre("TF has no data for the frame 'alpha' from 2.000 s to 3600.000 s "
                          "(3598.000 s): " +
                          std::to_string(timeline.left_out_gap) +
                          " scenes in between are left out (max_tf_gap: .inf makes them)"));
  TimelineOptions all = everyMilliseconds(500);
  all.max_tf_gap = Duration::max();
  const Timeline whole = acrossAnHour(5.0, all);
  EXPECT_EQ(whole.left_out_gap, 0);
  EXPECT_EQ(whole.stamps.size(),
            timeline.stamps.size() + static_cast<std::size_t>(timeline.left_out_gap));
  EXPECT_THAT(whole.diagnostics.messages(base::Severity::kWarning),
              ElementsAre(HasSubstr("made, its poses interpolated across")));
}

TEST(Timeline, MakesScenesInAHoleOverWhichNothingMoved) {
  const Timeline timeline = acrossAnHour(0.0, everyMilliseconds(500));
  EXPECT_EQ(timeline.left_out_gap, 0);
  EXPECT_THAT(timeline.diagnostics.messages(base::Severity::kWarning),
              ElementsAre(HasSubstr("made, as its pose is the same before and after")));
}

TEST(Timeline, TakesAFramesOwnSlowRateForNoHole) {
  const BagMotion motion =
      recorded([](BagBuilder& bag) { moveAlongX(bag, "map", "alpha", 1000, 301000, 15000); });
  const Timeline timeline = motion.timeline({"alpha"}, everyMilliseconds(1000));
  EXPECT_THAT(timeline.stamps, SizeIs(300));
  EXPECT_TRUE(timeline.diagnostics.all().empty());
}

TEST(Timeline, MindsGapsOnTheGlobalFramesSideToo) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    moveAlongX(bag, "earth", "map", 1000, 3000, 1000);
    moveAlongX(bag, "earth", "alpha", 1000, 3000);
  });
  TimelineOptions options = everyMilliseconds(500);
  options.max_tf_gap = milliseconds(999);
  const Timeline timeline = motion.timeline({"alpha"}, options);
  EXPECT_THAT(timeline.stamps, ElementsAre(milliseconds(1000), milliseconds(2000)));
  EXPECT_EQ(timeline.left_out_gap, 2);
}

TEST(Timeline, IgnoresGapsAboveTheCommonAncestor) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    moveAlongX(bag, "earth", "map", 1000, 3000, 2000);
    moveAlongX(bag, "map", "alpha", 1000, 3000);
  });
  TimelineOptions options = everyMilliseconds(500);
  options.max_tf_gap = milliseconds(100);
  EXPECT_EQ(motion.timeline({"alpha"}, options).left_out_gap, 0);
}

TEST(Timeline, TellsWhenGapsLeaveNoScene) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    moveAlongX(bag, "map", "alpha", 1050, 3050, 1000);
    bag.say("/chatter", milliseconds(1000));
  });
  TimelineOptions options = everyMilliseconds(100);
  options.max_tf_gap = milliseconds(500);
  EXPECT_THAT(messageOf([&] { static_cast<void>(motion.timeline({"alpha"}, options)); }),
              AllOf(HasSubstr("no scene is left"), HasSubstr("max_tf_gap, 0.500000000 s")));
}

TEST(Timeline, KnowsTheGlobalFrameItselfAtAllTimes) {
  const BagMotion motion =
      recorded([](BagBuilder& bag) { moveAlongX(bag, "map", "alpha", 1000, 2000); });
  EXPECT_THAT(motion.timeline({"map"}, everyMilliseconds(500)).stamps, SizeIs(2));
}

TEST(Timeline, IsFoundInLongRecordingsWithoutLookingAtEachTime) {
  constexpr std::int64_t kTenHours = 36000000;  // [ms]
  const BagMotion motion = recorded([](BagBuilder& bag) {
    moveAlongX(bag, "map", "alpha", 1000, 2000);
    moveAlongX(bag, "map", "bravo", kTenHours, kTenHours + 1000);
    moveAlongX(bag, "map", "charlie", 1000, kTenHours, kTenHours / 10);
  });
  // In steps of 1 ns there are 3.6e13 times: checking them one by one would take days.
  TimelineOptions options;
  options.period = Duration(1);
  EXPECT_THROW(static_cast<void>(motion.timeline({"alpha", "bravo"}, options)), std::runtime_error);
  EXPECT_THROW(static_cast<void>(motion.timeline({"charlie", "delta"}, options)),
               std::runtime_error);
  EXPECT_THAT(motion.timeline({"bravo"}, everyMilliseconds(1)).stamps, SizeIs(1000));
}

TEST(Timeline, RefusesMoreScenesThanFileNamesCanNumber) {
  const BagMotion motion =
      recorded([](BagBuilder& bag) { moveAlongX(bag, "map", "alpha", 1000, 2000); });
  TimelineOptions options;
  options.period = Duration(1);
  EXPECT_THAT(messageOf([&] { static_cast<void>(motion.timeline({"alpha"}, options)); }),
              AllOf(HasSubstr("1000000000 scenes"), HasSubstr("lower the rate")));
}

TEST(Timeline, SaysWhatAFrameCostsAndWhichLinkIsToBlame) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    moveAlongX(bag, "map", "odom", 1000, 3000);
    moveAlongX(bag, "odom", "alpha", 1000, 9000);
    moveAlongX(bag, "map", "bravo", 1000, 9000);
  });
  const Timeline timeline = motion.timeline({"alpha", "bravo"}, everyMilliseconds(500));
  EXPECT_EQ(timeline.used, milliseconds(8000));
  ASSERT_THAT(timeline.costs, SizeIs(1));
  EXPECT_EQ(timeline.costs[0].frame, "alpha");
  EXPECT_EQ(timeline.costs[0].unknown, milliseconds(6000));
  EXPECT_THAT(timeline.costs[0].why,
              HasSubstr("TF has 'odom' in 'map' from 1.000000000 s to 3.000000000 s"));
}

TEST(Timeline, GoesOnWithoutFramesThatNeedNotBeKnown) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    moveAlongX(bag, "map", "alpha", 1000, 9000);
    moveAlongX(bag, "map", "person", 4000, 5000);
  });
  TimelineOptions options = everyMilliseconds(500);
  options.sometimes = {"person"};
  const Timeline timeline = motion.timeline({"alpha"}, options);
  EXPECT_THAT(timeline.stamps, SizeIs(16));
  ASSERT_THAT(timeline.costs, SizeIs(1));
  EXPECT_EQ(timeline.costs[0].unknown, milliseconds(7000));
  options.sometimes = {"persom"};
  EXPECT_THAT(test::messagesOf([&] { (void)motion.timeline({"alpha"}, options); }),
              ElementsAre(AllOf(HasSubstr("frame 'persom' is not in the recording"),
                                HasSubstr("'person'"))));
}

TEST(Timeline, KnowsWhereAPoseWouldBeInterpolatedAcrossAHole) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    moveAlongX(bag, "map", "person", 1000, 2000);
    moveAlongX(bag, "map", "person", 30000, 31000);
  });
  const FrameId person = *motion.find("person");
  EXPECT_FALSE(motion.isInHole(person, milliseconds(1550), std::nullopt));
  EXPECT_TRUE(motion.isInHole(person, milliseconds(9000), std::nullopt));
  EXPECT_FALSE(motion.isInHole(person, milliseconds(9000), Duration::max()));
}

}  // namespace bag_motion_timeline_test
}  // namespace synthetic_dataset::motion
