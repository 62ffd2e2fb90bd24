#include "motion/tf/frame_findings.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/recorded.h"

namespace synthetic_dataset::motion {
namespace frame_findings_test {

using test::BagBuilder;
using test::milliseconds;
using test::poseAt;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

BagBuilder::Transform sentBy(const std::string& publisher, std::int64_t ms, double x, double y) {
  BagBuilder::Transform transform;
  transform.parent = "map";
  transform.child = "alpha";
  transform.stamp = transform.recorded = milliseconds(ms);
  transform.x = x;
  transform.y = y;
  transform.publisher = publisher;
  return transform;
}

TEST(FrameFindings, NameTwoPublishersThatFightOverAFrame) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    for (int i = 0; i < 40; ++i) {
      const bool is_first = i % 2 == 0;
      bag.add(
          sentBy(is_first ? "/amcl" : "/gmapping", 1000 + 50 * i, 0.01 * i, is_first ? 0.0 : 0.4));
    }
  });
  EXPECT_THAT(warningsOf(motion, {"alpha"}),
              ElementsAre(AllOf(HasSubstr("fight over the frame 'alpha'"),
                                HasSubstr("jumps to and fro in 'map' 38 times, first at "
                                          "1.050000000 s by 0.400 m"),
                                HasSubstr("/amcl, /gmapping"))));
}

TEST(FrameFindings, FindAFightWhoseMessagesComeInPairs) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    for (int i = 0; i < 40; ++i)
      bag.add(sentBy("", 1000 + 50 * i, 0.0, i / 2 % 2 == 0 ? 0.0 : 2.0));
  });
  EXPECT_THAT(warningsOf(motion, {"alpha"}), ElementsAre(HasSubstr("fight over")));
}

TEST(FrameFindings, FindNoFightInNoiseOrATurnBack) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    for (int i = 0; i < 200; ++i) {
      const double noise = 0.02 * ((i * 7919) % 101) / 101.0;
      const double x = i < 100 ? 0.05 * i : 0.05 * (200 - i);
      bag.add(sentBy("", 1000 + 50 * i, x, noise));
    }
  });
  EXPECT_THAT(warningsOf(motion, {"alpha"}), IsEmpty());
}

TEST(FrameFindings, FindNoFightInASwing) {
  constexpr double kTurn = 6.283185307179586;
  for (const int samples : {7, 8, 10, 14}) {  // per swing; fewer are too few to tell
    for (int phase = 0; phase < 20; ++phase) {
      const BagMotion motion = recorded([&](BagBuilder& bag) {
        for (int i = 0; i < 60; ++i) {
          const double turns = static_cast<double>(i) / samples + 0.05 * phase;
          bag.add(sentBy("", 1000 + 200 * i, 0.0, 0.3 * std::sin(kTurn * turns)));
        }
      });
      EXPECT_THAT(warningsOf(motion, {"alpha"}), IsEmpty()) << samples << ", " << phase;
    }
  }
}

TEST(FrameFindings, NameAFramesNewParent) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    for (int i = 0; i <= 20; ++i) {
      bag.move(i < 10 ? "table" : "gripper", "cup", milliseconds(1000 + 100 * i));
      bag.move("map", "gripper", milliseconds(1000 + 100 * i));
    }
    bag.fix("map", "table", milliseconds(1000));
  });
  EXPECT_THAT(warningsOf(motion, {"cup"}),
              ElementsAre("the frame 'cup' changes its parent from 'table' to 'gripper' at "
                          "2.000000000 s"));
  EXPECT_THAT(warningsOf(motion, {"table"}), IsEmpty()) << "what is not used does not matter";
}

TEST(FrameFindings, NameParentsThatAlternate) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    for (int i = 0; i <= 20; ++i) {
      bag.move(i % 2 == 0 ? "map" : "odom", "alpha", milliseconds(1000 + 100 * i));
    }
  });
  EXPECT_THAT(warningsOf(motion, {"alpha"}),
              ElementsAre(AllOf(HasSubstr("two publishers seem to fight"),
                                HasSubstr("between the parents 'map' and 'odom' 20 times"))));
}

TEST(FrameFindings, NameAFrameThatBothTopicsHave) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    bag.fix("map", "alpha", milliseconds(1000));
    bag.move("map", "alpha", milliseconds(2000), poseAt(1, 0, 0));
  });
  EXPECT_THAT(warningsOf(motion, {"alpha"}),
              ElementsAre(AllOf(HasSubstr("changes at 2.000000000 s"),
                                HasSubstr("/tf has this frame, too"))));
}

}  // namespace frame_findings_test
}  // namespace synthetic_dataset::motion
