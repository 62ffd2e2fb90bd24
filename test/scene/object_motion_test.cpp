#include "scene/object_motion.h"

#include <gmock/gmock.h>

#include "support/bag_builder.h"
#include "support/fake_frame_source.h"

namespace synthetic_dataset::scene {
namespace object_motion_test {

using test::FakeFrameSource;
using test::milliseconds;
using test::poseAt;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Drives along x, and is known until 2 s.
std::optional<Pose> baseAt(Stamp time) {
  if (time > milliseconds(2000)) return std::nullopt;
  return poseAt(toSeconds(time), 0, 0);
}

/// Rises above the base, and is known from 1 s on.
std::optional<Pose> foreAt(Stamp time) {
  if (time < milliseconds(1000)) return std::nullopt;
  return poseAt(toSeconds(time), 0, 2.0 * toSeconds(time));
}

/// The object alpha: a base, and half a metre above it a link that follows a frame of its own.
class ObjectMotionTest : public testing::Test {
 protected:
  ObjectMotionTest() {
    base_link_.name = "base";
    fore_link_.name = "fore";
    fore_link_.parent = 0;
    fore_link_.X_ML = poseAt(0, 0, 0.5);
    options_.name = "alpha";
    options_.frame = "alpha/base_link";
  }

  [[nodiscard]] ObjectMotion motion() const {
    const std::vector<world::LinkInstance> links{{&base_link_, world::Role::kObject, 0, "alpha"},
                                                 {&fore_link_, world::Role::kObject, 0, "alpha"}};
    return ObjectMotion(frames_, {options_}, links, {{{{1, *frames_.find("alpha/fore")}}}});
  }

  FakeFrameSource frames_{{{"alpha/base_link", baseAt}, {"alpha/fore", foreAt}}};
  world::Link base_link_, fore_link_;
  ObjectOptions options_;
};

TEST_F(ObjectMotionTest, FollowsTheFramesOfTheObjectAndOfItsLinks) {
  ObjectMotion alpha = motion();
  const world::ObjectPose pose = alpha.at(0, milliseconds(1500)).value();
  EXPECT_TRUE(pose.X_WO.isApprox(poseAt(1.5, 0, 0)));
  ASSERT_THAT(pose.X_WL, SizeIs(1));
  EXPECT_TRUE(pose.X_WL.front().isApprox(poseAt(1.5, 0, 3)));
  EXPECT_THAT(alpha.takeGaps(), IsEmpty());
}

TEST_F(ObjectMotionTest, LeavesAnObjectWhereItWasSeenLast) {
  ObjectMotion alpha = motion();
  static_cast<void>(alpha.objectPoses(milliseconds(1750)));
  EXPECT_TRUE(alpha.objectPoses(milliseconds(2500)).front()->isApprox(poseAt(1.75, 0, 0)));
}

TEST_F(ObjectMotionTest, LeavesAnObjectNowhereThatWasNeverSeen) {
  options_.frame = "bravo/base_link";
  ObjectMotion bravo = motion();
  EXPECT_FALSE(bravo.at(0, milliseconds(250)).has_value());
  EXPECT_FALSE(bravo.objectPoses(milliseconds(250)).front().has_value());
}

TEST_F(ObjectMotionTest, LeavesALinkWhereItIsOnItsParentAndReportsThatOnceATime) {
  ObjectMotion alpha = motion();
  EXPECT_TRUE(alpha.at(0, milliseconds(250))->X_WL.front().isApprox(poseAt(0.25, 0, 0.5)));
  EXPECT_THAT(alpha.takeGaps(), ElementsAre(HasSubstr("'alpha': the frame 'alpha/fore' of its "
                                                      "link 'fore' is not known")));
  EXPECT_THAT(alpha.takeGaps(), IsEmpty());
  static_cast<void>(alpha.at(0, milliseconds(500)));
  static_cast<void>(alpha.at(0, milliseconds(600)));
  EXPECT_THAT(alpha.takeGaps(), SizeIs(1));  // reported again: this is another scene
}

TEST_F(ObjectMotionTest, IsNowhereWhileAnObjectThatMayBeAbsentIsNotKnown) {
  options_.when_unknown = WhenUnknown::kAbsent;
  ObjectMotion alpha = motion();
  EXPECT_TRUE(alpha.at(0, milliseconds(1500)));
  EXPECT_FALSE(alpha.at(0, milliseconds(2500)));
  EXPECT_FALSE(alpha.objectPoses(milliseconds(2500)).front());
}

}  // namespace object_motion_test
}  // namespace synthetic_dataset::scene
