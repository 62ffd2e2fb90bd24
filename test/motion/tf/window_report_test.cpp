// What BagMotion::timeline() says when there is no timeline.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/recorded.h"
#include "support/error_messages.h"

namespace synthetic_dataset::motion {
namespace window_report_test {

using test::BagBuilder;
using test::milliseconds;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> timelineErrors(const BagMotion& motion,
                                        const std::vector<std::string>& frames,
                                        const TimelineOptions& options = everyMilliseconds(100)) {
  return test::messagesOf([&] { static_cast<void>(motion.timeline(frames, options)); });
}

TEST(WindowReport, TellsFromWhenToWhenEachFrameIsKnown) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    bag.fix("map", "camera", milliseconds(1650000000000));
    moveAlongX(bag, "map", "alpha", 1650000000100, 1650000001000);
    moveAlongX(bag, "map", "bravo", 1650000002000, 1650000003000);
  });
  EXPECT_THAT(
      timelineErrors(motion, {"alpha", "bravo", "camera"}),
      ElementsAre(AllOf(HasSubstr("no stretch of time between 1650000000.000000000 s and "
                                  "1650000003.000000000 s"),
                        HasSubstr("into 'map'"), HasSubstr("steps of 0.100000000 s")),
                  "frame 'alpha' can be transformed into 'map' from 1650000000.100000000 s to "
                  "1650000001.000000000 s (0.100 s to 1.000 s after the recording's start)",
                  "frame 'bravo' can be transformed into 'map' from 1650000002.000000000 s to "
                  "1650000003.000000000 s (2.000 s to 3.000 s after the recording's start)",
                  "frame 'camera' can be transformed into 'map' at all times"));
}

TEST(WindowReport, ListsTheFirstOfManyStretches) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    bag.say("/chatter", milliseconds(1));
    for (int i = 0; i < 6; ++i) {
      bag.move("map", "alpha", milliseconds(1050 + 200 * i));
      bag.move("elsewhere", "alpha", milliseconds(1051 + 200 * i));
    }
  });
  EXPECT_THAT(timelineErrors(motion, {"alpha"}, everyMilliseconds(100)).back(),
              AllOf(HasSubstr("from 1.050000000 s to 1.050999999 s"),
                    HasSubstr("from 1.450000000 s to 1.450999999 s"),
                    HasSubstr("and in 3 more stretches up to 2.050999999 s")));
}

TEST(WindowReport, NamesUnknownFramesAllAtOnce) {
  const BagMotion motion = recorded(
      [](BagBuilder& bag) {
        moveAlongX(bag, "map", "alpha/base_link", 1000, 2000);
        moveAlongX(bag, "map", "bravo/base_link", 1000, 2000);
      },
      "/world");
  EXPECT_THAT(timelineErrors(motion, {"alpha/baselink", "bravo/base_link", "robots/charlie"}),
              ElementsAre(AllOf(HasSubstr("global frame 'world' is not in the recording"),
                                HasSubstr("its frames are alpha/base_link, bravo/base_link, map")),
                          "frame 'alpha/baselink' is not in the recording; did you mean "
                          "'alpha/base_link'?",
                          HasSubstr("frame 'robots/charlie' is not in the recording")));
}

TEST(WindowReport, ShortensLongListsOfFrames) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    for (int i = 10; i < 30; ++i) bag.fix("map", "f" + std::to_string(i), milliseconds(1000));
    bag.say("/chatter", milliseconds(2000));
  });
  EXPECT_THAT(timelineErrors(motion, {"chimney"}),
              ElementsAre(AllOf(HasSubstr("its frames are f10, f11,"), HasSubstr("and 9 more"))));
}

TEST(WindowReport, TellsInWhichTreeAnUnconnectedFrameIs) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    moveAlongX(bag, "earth", "map", 1000, 2000);
    moveAlongX(bag, "bravo/odom", "bravo/base_link", 1000, 2000);
  });
  EXPECT_THAT(timelineErrors(motion, {"bravo/base_link"}).back(),
              AllOf(HasSubstr("frame 'bravo/base_link' can be transformed into 'map' at no time"),
                    HasSubstr("'bravo/base_link' is in the tree of 'bravo/odom'"),
                    HasSubstr("'map' in that of 'earth'")));
}

TEST(WindowReport, TellsOfLinksThatAreNeverKnownTogether) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    moveAlongX(bag, "map", "odom", 1000, 2000);
    moveAlongX(bag, "odom", "alpha", 3000, 4000);
  });
  EXPECT_THAT(timelineErrors(motion, {"alpha"}).back(),
              HasSubstr("never all known at the same time"));
}

TEST(WindowReport, SuspectsAnotherClock) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    moveAlongX(bag, "map", "bravo", 1650000000000, 1650000002000);
    BagBuilder::Transform transform;
    transform.parent = "map";
    transform.child = "alpha";
    for (int i = 0; i < 10; ++i) {
      transform.stamp = milliseconds(12000 + 100 * i);  // simulation time
      transform.recorded = milliseconds(1650000000000 + 100 * i);
      bag.add(transform);
    }
  });
  EXPECT_THAT(timelineErrors(motion, {"alpha"}).back(),
              AllOf(HasSubstr("from 12.000000000 s to 12.900000000 s"),
                    HasSubstr("outside the recording"), HasSubstr("use_sim_time")));
  EXPECT_FALSE(motion.hasOwnClock());
}

TEST(WindowReport, NamesOptionsThatLeaveNothing) {
  const BagMotion motion =
      recorded([](BagBuilder& bag) { moveAlongX(bag, "map", "alpha", 1000, 2000); });
  TimelineOptions options;
  options.start_offset = milliseconds(1000);
  options.duration = Duration(0);
  EXPECT_THAT(timelineErrors(motion, {"alpha"}, options),
              ElementsAre(HasSubstr("the period is 0.000000000 s"),
                          AllOf(HasSubstr("the start offset of 1.000000000 s leaves nothing"),
                                HasSubstr("the recording lasts 1.000000000 s")),
                          HasSubstr("the duration is 0.000000000 s")));
}

}  // namespace window_report_test
}  // namespace synthetic_dataset::motion
