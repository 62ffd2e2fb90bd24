#include "motion/bag_motion.h"

#include <cmath>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/recorded.h"
#include "support/error_messages.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::motion {
namespace bag_motion_test {

using test::BagBuilder;
using test::milliseconds;
using test::poseAt;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

double yawOf(const Pose& X) { return std::atan2(X.linear()(1, 0), X.linear()(0, 0)); }

TEST(BagMotion, InterpolatesPositionsLinearlyAndRotationsByAngle) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    bag.move("map", "alpha", milliseconds(1000), poseAt(1, 2, 3, 0.2));
    bag.move("map", "alpha", milliseconds(2000), poseAt(5, 0, 3, 1.4));
  });
  const Pose X = poseOf(motion, "alpha", milliseconds(1250));
  EXPECT_TRUE(X.translation().isApprox(Eigen::Vector3d(2.0, 1.5, 3.0), 1e-12));
  EXPECT_NEAR(yawOf(X), 0.5, 1e-12);
}

TEST(BagMotion, KnowsHowOftenAFrameIsRecorded) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    bag.fix("map", "stone", milliseconds(1000));
    for (int i = 0; i <= 20; ++i) {
      if (i % 10 == 0) bag.move("map", "odom", milliseconds(1000 + 50 * i));
      bag.move("odom", "alpha", milliseconds(1000 + 50 * i), poseAt(i, 0, 0));
    }
  });
  const Stamp time = milliseconds(1500);
  EXPECT_EQ(motion.recordedPeriod(*motion.find("alpha"), time), milliseconds(50))
      << "its own transform, the most frequent one on the way";
  EXPECT_EQ(motion.recordedPeriod(*motion.find("odom"), time), milliseconds(500));
  EXPECT_EQ(motion.recordedPeriod(*motion.find("stone"), time), std::nullopt);
}

TEST(BagMotion, TakesTheShorterWayBetweenRotationsInSpace) {
  const Eigen::Quaterniond q1 = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized();
  const Eigen::Quaterniond q2 = Eigen::Quaterniond(-0.6, 0.4, -0.5, 0.1).normalized();
  ASSERT_LT(q1.dot(q2), 0.0);  // the far sides: q and -q are the same rotation
  const BagMotion motion = recorded([&](BagBuilder& bag) {
    BagBuilder::Transform transform;
    transform.parent = "map";
    transform.child = "alpha";
    for (const auto& [q, ms] : {std::pair(q1, 1000), std::pair(q2, 1500)}) {
      transform.stamp = transform.recorded = milliseconds(ms);
      transform.qx = q.x();
      transform.qy = q.y();
      transform.qz = q.z();
      transform.qw = q.w();
      bag.add(transform);
    }
  });
  for (const int ms : {1000, 1100, 1350, 1499}) {
    const Eigen::Quaterniond expected = q1.slerp((ms - 1000) / 500.0, q2);
    EXPECT_TRUE(poseOf(motion, "alpha", milliseconds(ms))
                    .linear()
                    .isApprox(expected.toRotationMatrix(), 1e-9))
        << ms;
  }
}

TEST(BagMotion, AnswersExactlyAtASample) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    for (int i = 0; i < 5; ++i) {
      bag.move("map", "alpha", milliseconds(1000 + 100 * i), poseAt(i, 0, 0, 0.1 * i));
    }
  });
  for (int i = 0; i < 5; ++i) {
    const Pose X = poseOf(motion, "alpha", milliseconds(1000 + 100 * i));
    EXPECT_EQ(X.translation().x(), i);
    EXPECT_NEAR(yawOf(X), 0.1 * i, 1e-12);
  }
}

TEST(BagMotion, KeepsNanosecondsOfUnixTimes) {
  constexpr Stamp kStart(1650000000123456789);
  const BagMotion motion = recorded([&](BagBuilder& bag) {
    bag.move("map", "alpha", kStart, poseAt(0, 0, 0));
    bag.move("map", "alpha", kStart + Duration(1000), poseAt(1000, 0, 0));
  });
  EXPECT_EQ(motion.times().start, kStart);
  EXPECT_EQ(motion.times().end, kStart + Duration(1000));
  const Pose X = poseOf(motion, "alpha", kStart + Duration(321));
  EXPECT_NEAR(X.translation().x(), 321.0, 1e-9);
}

TEST(BagMotion, ComposesNestedFramesOfDifferentRates) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    bag.fix("base", "sensor", milliseconds(1000), poseAt(0, 0, 0.5));
    moveAlongX(bag, "map", "odom", 1000, 3000, 1000);
    moveAlongX(bag, "odom", "base", 1000, 3000, 30);
  });
  const Pose X = poseOf(motion, "sensor", milliseconds(1777));
  EXPECT_TRUE(X.translation().isApprox(Eigen::Vector3d(2 * 1.777, 0, 0.5), 1e-12));
}

TEST(BagMotion, NormalisesRotations) {
  const BagMotion motion = recorded([](BagBuilder& bag) {
    BagBuilder::Transform transform;
    transform.parent = "map";
    transform.child = "alpha";
    transform.stamp = transform.recorded = milliseconds(1000);
    transform.qw = 1.004;
    bag.add(transform);
  });
  const Pose X = poseOf(motion, "alpha", milliseconds(1000));
  EXPECT_TRUE(X.linear().isIdentity(1e-15));
}

TEST(BagMotion, StripsLeadingSlashesOnBothSides) {
  const BagMotion motion = recorded(
      [](BagBuilder& bag) {
        bag.move("/map", "/alpha/base_link", milliseconds(1000), poseAt(7, 0, 0));
      },
      "/map");
  EXPECT_TRUE(isKnown(motion, "/alpha/base_link", milliseconds(1000)));
  EXPECT_EQ(poseOf(motion, "alpha/base_link", milliseconds(1000)).translation().x(), 7);
}

TEST(BagMotion, CountsSeveralBagsAsOneRecording) {
  const test::TemporaryFolder folder;
  const std::string first = BagBuilder(folder / "1.bag")
                                .move("map", "alpha", milliseconds(1000), poseAt(1, 0, 0))
                                .close();
  const std::string second = BagBuilder(folder / "2.bag")
                                 .move("map", "alpha", milliseconds(2000), poseAt(2, 0, 0))
                                 .fix("alpha", "camera", milliseconds(2000), poseAt(0, 0, 1))
                                 .close();
  const BagMotion motion({second, first}, "map");
  EXPECT_EQ(motion.times().start, milliseconds(1000));
  EXPECT_EQ(motion.times().end, milliseconds(2000));
  const Pose X = poseOf(motion, "camera", milliseconds(1500));
  EXPECT_TRUE(X.translation().isApprox(Eigen::Vector3d(1.5, 0, 1), 1e-12));
}

TEST(BagMotion, CanBeMovedAndOutlivesItsFile) {
  BagMotion motion = recorded([](BagBuilder& bag) { moveAlongX(bag, "map", "alpha", 1000, 2000); });
  const BagMotion moved = std::move(motion);
  EXPECT_NEAR(poseOf(moved, "alpha", milliseconds(1234)).translation().x(), 1.234, 1e-12);
}

TEST(BagMotion, SaysAtWhichTimeAFrameIsNotKnown) {
  const BagMotion motion =
      recorded([](BagBuilder& bag) { moveAlongX(bag, "map", "alpha", 1000, 2000); });
  EXPECT_EQ(
      messageOf([&] { static_cast<void>(poseOf(motion, "alpha", milliseconds(2500))); }),
      "the frame 'alpha' is not known in 'map' at 2.500000000 s; it is known from 1.000000000 s to "
      "2.000000000 s (0.000 s to 1.000 s after the recording's start)");
  EXPECT_EQ(motion.lacks("alpa"), "the recording has no frame 'alpa'; did you mean 'alpha'?");
  EXPECT_EQ(motion.find("alpa"), std::nullopt);
  EXPECT_EQ(motion.pose(kNoFrame, milliseconds(1500)), std::nullopt);
}

TEST(BagMotion, KnowsNothingInAGlobalFrameThatItDoesNotHave) {
  const BagMotion motion =
      recorded([](BagBuilder& bag) { moveAlongX(bag, "map", "alpha", 1000, 2000); }, "elsewhere");
  EXPECT_FALSE(isKnown(motion, "alpha", milliseconds(1500)));
}

TEST(BagMotion, DoesNotTakeTimeZeroForTheLatest) {
  const BagMotion motion =
      recorded([](BagBuilder& bag) { bag.fix("map", "camera", milliseconds(1000)); });
  for (const Stamp time : {Stamp(0), Stamp(-1), Stamp::max()}) {
    EXPECT_FALSE(isKnown(motion, "camera", time));
  }
}

void writeBadTransforms(BagBuilder& bag) {
  moveAlongX(bag, "map", "alpha", 1000, 2000);
  BagBuilder::Transform bad;
  bad.parent = "map";
  bad.child = "/alpha";
  for (int i = 0; i < 3; ++i) {
    bad.stamp = bad.recorded = milliseconds(1250 + i);
    bad.x = std::nan("");
    bag.add(bad);
  }
  bad.x = 0.0;
  bad.qw = 0.5;
  bag.add(bad);
  bad.qw = 1.0;
  bad.child = "/";
  bag.add(bad);
  bag.move("map", "map", milliseconds(1300));
}

TEST(BagMotion, LeavesOutWhatTf2WouldRefuseAndTellsIt) {
  const BagMotion motion = recorded(writeBadTransforms);
  EXPECT_THAT(
      warningsOf(motion, {"alpha"}),
      ElementsAre(AllOf(HasSubstr("recorded.bag: 3 transforms of map -> alpha were left "
                                  "out: NaN in the translation"),
                        HasSubstr("(first at 1.250000000 s)")),
                  HasSubstr("1 transform of map -> alpha was left out: the rotation"),
                  HasSubstr("1 transform of map -> (no name) was left out: the child frame has no "
                            "name"),
                  HasSubstr("1 transform of map -> map was left out: the frame is its "
                            "own parent")));
  EXPECT_NEAR(poseOf(motion, "alpha", milliseconds(1251)).translation().x(), 1.251, 1e-12);
}

TEST(BagMotion, PrintsNothing) {
  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  const BagMotion motion = recorded([](BagBuilder& bag) {
    writeBadTransforms(bag);
    bag.move("map", "alpha", milliseconds(2000), poseAt(9, 9, 9));  // a second time
  });
  EXPECT_FALSE(isKnown(motion, "", milliseconds(1500)));
  EXPECT_THAT(::testing::internal::GetCapturedStdout(), IsEmpty());
  EXPECT_THAT(::testing::internal::GetCapturedStderr(), IsEmpty());
}

TEST(BagMotion, RefusesARecordingWithoutAUsableTransform) {
  EXPECT_THAT(test::messagesOf([] {
                static_cast<void>(
                    recorded([](BagBuilder& bag) { bag.move("map", "map", milliseconds(1000)); }));
              }),
              ElementsAre(HasSubstr("hold no transform that can be used"),
                          HasSubstr("the frame is its own parent")));
}

}  // namespace bag_motion_test
}  // namespace synthetic_dataset::motion
