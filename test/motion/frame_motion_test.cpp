#include "motion/frame_motion.h"

#include <memory>

#include <gmock/gmock.h>

#include "motion/recorded.h"

namespace synthetic_dataset::motion {
namespace {

using test::BagBuilder;
using test::milliseconds;
using test::poseAt;
using ::testing::HasSubstr;

/// A second in which alpha drives along x: at 1.5 s it is at x = 1.5. The frame `hall` stands.
FrameMotion recordedMotion(const std::string& global_frame = "map") {
  return {global_frame, std::make_unique<BagMotion>(recorded([](BagBuilder& bag) {
            moveAlongX(bag, "map", "alpha/base_link", 1000, 2000);
            bag.fix("map", "hall", milliseconds(1000), poseAt(0, 4, 0));
          }))};
}

FrameMotion placedMotion() { return {"map", nullptr}; }

void expectAt(const FrameMotion& motion, const std::string& frame, Stamp time, double x, double y) {
  ASSERT_TRUE(motion.hasPose(frame, time)) << frame;
  EXPECT_TRUE(motion.pose(frame, time).translation().isApprox(Eigen::Vector3d(x, y, 0), 1e-9))
      << frame;
}

TEST(FrameMotion, HasPlacedFramesAtAnyTime) {
  FrameMotion motion = placedMotion();
  const Pose X_GF = poseAt(1, 2, 3, 0.4);
  motion.place("alpha/base_link", X_GF);
  for (const Stamp time : {Stamp(0), milliseconds(1500), milliseconds(1'000'000'000)}) {
    EXPECT_TRUE(motion.hasPose("alpha/base_link", time));
    EXPECT_TRUE(motion.pose("alpha/base_link", time).matrix() == X_GF.matrix());
  }
  EXPECT_TRUE(motion.isPlaced("alpha/base_link"));
  EXPECT_TRUE(motion.knowsFrame("alpha/base_link"));
}

TEST(FrameMotion, HasFramesWhereTheyWerePlacedLast) {
  FrameMotion motion = placedMotion();
  motion.place("alpha", poseAt(1, 0, 0));
  motion.place("bravo", poseAt(2, 0, 0));
  motion.place("alpha", poseAt(3, 0, 0));
  expectAt(motion, "alpha", milliseconds(1), 3, 0);
  expectAt(motion, "bravo", milliseconds(1), 2, 0);
}

TEST(FrameMotion, FollowsTheRecording) {
  const FrameMotion motion = recordedMotion();
  ASSERT_NE(motion.recording(), nullptr);
  expectAt(motion, "alpha/base_link", milliseconds(1250), 1.25, 0);
  expectAt(motion, "hall", milliseconds(1250), 0, 4);
  EXPECT_FALSE(motion.hasPose("alpha/base_link", milliseconds(2500)));
  EXPECT_FALSE(motion.isPlaced("alpha/base_link"));
  EXPECT_TRUE(motion.knowsFrame("alpha/base_link"));
}

TEST(FrameMotion, HasRecordedFramesInTheGlobalOne) {
  const FrameMotion motion = recordedMotion("hall");
  expectAt(motion, "alpha/base_link", milliseconds(1250), 1.25, -4);
  expectAt(motion, "hall", milliseconds(1250), 0, 0);
}

TEST(FrameMotion, PlacesOverTheRecording) {
  FrameMotion motion = recordedMotion();
  motion.place("alpha/base_link", poseAt(7, 7, 0));
  expectAt(motion, "alpha/base_link", milliseconds(1250), 7, 7);
  expectAt(motion, "alpha/base_link", milliseconds(9999), 7, 7);
  expectAt(motion, "hall", milliseconds(1250), 0, 4);
}

TEST(FrameMotion, TakesNoNoticeOfLeadingSlashes) {
  FrameMotion motion("/map", nullptr);
  EXPECT_EQ(motion.globalFrame(), "map");
  motion.place("/alpha", poseAt(1, 0, 0));
  expectAt(motion, "alpha", milliseconds(1), 1, 0);
  motion.place("bravo", poseAt(2, 0, 0));
  expectAt(motion, "//bravo", milliseconds(1), 2, 0);
  EXPECT_TRUE(motion.isPlaced("/bravo"));
  EXPECT_TRUE(motion.knowsFrame("/bravo"));
  expectAt(motion, "/map", milliseconds(1), 0, 0);
  expectAt(recordedMotion("/map"), "/alpha/base_link", milliseconds(1250), 1.25, 0);
}

TEST(FrameMotion, KnowsTheGlobalFrameWithoutARecording) {
  const FrameMotion motion = placedMotion();
  EXPECT_EQ(motion.recording(), nullptr);
  EXPECT_TRUE(motion.knowsFrame("map"));
  EXPECT_FALSE(motion.isPlaced("map"));
  expectAt(motion, "map", milliseconds(1), 0, 0);
}

TEST(FrameMotion, KnowsNothingElseWithoutARecording) {
  FrameMotion motion = placedMotion();
  motion.place("alpha/base_link", poseAt(1, 0, 0));
  EXPECT_FALSE(motion.knowsFrame("alpha/wheel"));
  EXPECT_FALSE(motion.hasPose("alpha/wheel", milliseconds(1)));
  EXPECT_EQ(messageOf([&] { (void)motion.pose("/alpha/base_lonk", milliseconds(1)); }),
            "the frame 'alpha/base_lonk' is not known; did you mean 'alpha/base_link'?");
}

TEST(FrameMotion, SuggestsNoFrameThatIsNotAlike) {
  FrameMotion motion = placedMotion();
  motion.place("alpha/base_link", poseAt(1, 0, 0));
  EXPECT_EQ(motion.suggestFrame("odometry"), "");
  EXPECT_THAT(motion.suggestFrame("mop"), HasSubstr("did you mean 'map'?"));
}

TEST(FrameMotion, SuggestsRecordedFrames) {
  const FrameMotion motion = recordedMotion();
  EXPECT_THAT(motion.suggestFrame("haul"), HasSubstr("did you mean 'hall'?"));
  EXPECT_FALSE(motion.knowsFrame("haul"));
  EXPECT_THAT(messageOf([&] { (void)motion.pose("haul", milliseconds(1250)); }), HasSubstr("haul"));
}

}  // namespace
}  // namespace synthetic_dataset::motion
