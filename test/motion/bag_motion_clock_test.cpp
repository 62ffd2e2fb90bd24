// Recordings whose time stamps come from another clock than their record times, or in which time
// goes back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/recorded.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::motion {
namespace bag_motion_clock_test {

using test::BagBuilder;
using test::milliseconds;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

/// Adds a transform from "map" whose x is its stamp in seconds, plus `side`.
void moveAt(BagBuilder& bag, const std::string& child, std::int64_t stamp_ms,
            std::int64_t recorded_ms, double side = 0.0) {
  BagBuilder::Transform transform;
  transform.parent = "map";
  transform.child = child;
  transform.stamp = milliseconds(stamp_ms);
  transform.recorded = milliseconds(recorded_ms);
  transform.x = static_cast<double>(stamp_ms) / 1000.0 + side;
  bag.add(transform);
}

/// Ten seconds of simulation time, recorded by a clock that is ahead.
BagMotion recordedAhead(std::int64_t ahead_ms) {
  return recorded([&](BagBuilder& bag) {
    for (int i = 0; i <= 100; ++i) {
      moveAt(bag, "alpha", 100000 + 100 * i, 100000 + 100 * i + ahead_ms);
    }
  });
}

TEST(BagMotionClock, ScenesBeginWithTheFirstKnownStampOfAnotherClock) {
  for (const std::int64_t ahead_ms : {2000, -2000, 1650000000}) {
    const BagMotion motion = recordedAhead(ahead_ms);
    const Timeline timeline = motion.timeline({"alpha"}, everyMilliseconds(700));
    ASSERT_THAT(timeline.stamps, SizeIs(15)) << "begun periods of 0.7 s in 10 s";
    EXPECT_EQ(timeline.stamps.front(), milliseconds(100000));
    EXPECT_EQ(timeline.stamps.back(), milliseconds(100000 + 14 * 700));
    EXPECT_THAT(timeline.diagnostics.messages(base::Severity::kWarning),
                ElementsAre(AllOf(HasSubstr(ahead_ms > 0 ? "s behind its record times"
                                                         : "2.000000000 s ahead of its record"),
                                  HasSubstr("100.000000000 s"))));
  }
}

TEST(BagMotionClock, ASecondsPartIsDelayAndNoOtherClock) {
  const BagMotion motion = recordedAhead(900);
  const Timeline timeline = motion.timeline({"alpha"}, everyMilliseconds(500));
  EXPECT_EQ(timeline.stamps.front(), milliseconds(100900)) << "as the recording starts";
  EXPECT_THAT(timeline.diagnostics.all(), IsEmpty());
}

TEST(BagMotionClock, OptionsCountFromTheFirstKnownStamp) {
  TimelineOptions options = everyMilliseconds(500);
  options.start_offset = milliseconds(2000);
  options.duration = milliseconds(1000);
  EXPECT_THAT(recordedAhead(5000).timeline({"alpha"}, options).stamps,
              ElementsAre(milliseconds(102000), milliseconds(102500)));
}

/// Nine seconds, then five seconds again from the start, 50 m farther along x.
void writeReset(BagBuilder& bag, bool records_simulation_time) {
  std::int64_t wall = 500000;
  const auto moveBoth = [&](std::int64_t stamp, double side) {
    for (const char* frame : {"alpha", "bravo"}) {
      moveAt(bag, frame, stamp, records_simulation_time ? stamp : wall, side);
    }
    wall += 100;
  };
  for (int i = 0; i <= 90; ++i) moveBoth(1000 + 100 * i, 0.0);
  for (int i = 0; i <= 50; ++i) moveBoth(1000 + 100 * i, 50.0);
}

TEST(BagMotionClock, ARecordingIsCutWhereASimulationWasReset) {
  for (const bool records_simulation_time : {false, true}) {
    const BagMotion motion =
        recorded([&](BagBuilder& bag) { writeReset(bag, records_simulation_time); });
    const Timeline timeline = motion.timeline({"alpha", "bravo"}, everyMilliseconds(500));
    EXPECT_THAT(timeline.stamps, SizeIs(18));
    EXPECT_EQ(timeline.stamps.front(), milliseconds(1000));
    for (const Stamp stamp : timeline.stamps) {
      EXPECT_NEAR(poseOf(motion, "alpha", stamp).translation().x(), toSeconds(stamp), 1e-9);
    }
    EXPECT_THAT(warningsOf(motion, {"alpha"}),
                ElementsAre(AllOf(HasSubstr("0: 1.000 s to 10.000 s (9.000 s), 1: 1.000 s to 6.000 "
                                            "s (5.000 s)"),
                                  HasSubstr("scenes come from stretch 0"))));
  }
}

TEST(BagMotionClock, AnotherStretchCanBeChosen) {
  test::TemporaryFolder folder;
  BagBuilder bag(folder / "reset.bag");
  writeReset(bag, false);
  const std::string file = bag.close();
  const BagMotion second(BagMotionOptions{{file}, "map", 1});
  const Timeline timeline = second.timeline({"alpha"}, everyMilliseconds(500));
  EXPECT_THAT(timeline.stamps, SizeIs(10));
  for (const Stamp stamp : timeline.stamps) {
    EXPECT_NEAR(poseOf(second, "alpha", stamp).translation().x(), toSeconds(stamp) + 50.0, 1e-9);
  }
  EXPECT_THAT(messageOf([&] {
                const BagMotion third(BagMotionOptions{{file}, "map", 2});
              }),
              AllOf(HasSubstr("stretch: found 2"), HasSubstr("1: 1.000 s to 6.000 s")));
}

TEST(BagMotionClock, TwoRunsInTwoBagsAreNotMixed) {
  test::TemporaryFolder folder;
  std::vector<std::string> files;
  for (int run = 0; run < 2; ++run) {
    BagBuilder bag(folder / (std::to_string(run) + ".bag"));
    for (int i = 0; i <= 50 + 10 * run; ++i) {
      moveAt(bag, "alpha", 1000 + 100 * i, 500000 + 100000 * run + 100 * i, 50.0 * run);
    }
    files.push_back(bag.close());
  }
  const BagMotion motion(files, "map");
  EXPECT_NEAR(poseOf(motion, "alpha", milliseconds(2050)).translation().x(), 52.05, 1e-9);
}

TEST(BagMotionClock, AStaticTransformOutlivesAReset) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    BagBuilder::Transform camera{"/tf_static", "alpha", "camera", milliseconds(1),
                                 milliseconds(499999)};
    bag.add(camera);
    for (int i = 0; i <= 20; ++i) moveAt(bag, "alpha", 5000 + 100 * i, 500000 + 100 * i);
    for (int i = 0; i <= 40; ++i) moveAt(bag, "alpha", 1000 + 100 * i, 510000 + 100 * i);
  });
  EXPECT_TRUE(isKnown(motion, "camera", milliseconds(1500)));
}

TEST(BagMotionClock, WhatComesLateIsNoReset) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    for (int i = 0; i <= 50; ++i) {
      const int late = i % 10 == 5 ? i - 3 : i;  // overtaken by three others
      moveAt(bag, "alpha", 1000 + 100 * late, 1000 + 100 * i);
    }
  });
  EXPECT_THAT(warningsOf(motion, {"alpha"}), Each(Not(HasSubstr("stretch"))));
}

TEST(BagMotionClock, OneFrameThatGoesBackAloneIsReportedAndCutsNothing) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    for (int i = 0; i <= 50; ++i) {
      for (const char* frame : {"alpha", "bravo", "charlie"}) {
        moveAt(bag, frame, 1000 + 100 * i, 1000 + 100 * i);
      }
      const int replayed = i < 25 ? i : i - 20;
      moveAt(bag, "delta", 1000 + 100 * replayed, 1000 + 100 * i, i < 25 ? 0.0 : 3.0);
    }
  });
  EXPECT_FALSE(motion.hasOwnClock());
  EXPECT_THAT(warningsOf(motion, {"delta"}),
              Contains(HasSubstr("time stamps of the frame 'delta' go back")));
  EXPECT_THAT(warningsOf(motion, {"alpha"}), Each(Not(HasSubstr("delta' go back"))));
}

}  // namespace bag_motion_clock_test
}  // namespace synthetic_dataset::motion
