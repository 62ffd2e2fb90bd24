#include "motion/tf/joint_frames.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/bag_builder.h"

namespace synthetic_dataset::motion {
namespace joint_frames_test {

using test::poseAt;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// ground -fixed- base -turns about z- upper -slides along x- fore; `twin`, on the base, follows
/// the slide by half.
JointedRobot arm() {
  JointedRobot robot{"arm", "arm/base", 1, {}};
  JointedLink ground{"arm/ground"};
  JointedLink base{"arm/base", 0, poseAt(0, 0, 0.3)};
  JointedLink upper{"arm/upper", 1, poseAt(0, 0, 0.2), "shoulder", false, {0, 0, 1}};
  JointedLink fore{"arm/fore", 2, poseAt(0, 0, 0.5), "slide", true, {1, 0, 0}};
  JointedLink twin{"arm/twin", 1, poseAt(1, 0, 0), "twin", true, {1, 0, 0}};
  twin.rest = 0.25;
  twin.mimic = JointedLink::Mimic{"slide", 0.5, 0.25};
  robot.links = {ground, base, upper, fore, twin};
  return robot;
}

sensor_msgs::JointState positions(const std::vector<std::string>& names,
                                  const std::vector<double>& values) {
  sensor_msgs::JointState message;
  message.name = names;
  message.position = values;
  return message;
}

Pose poseIn(const geometry_msgs::TransformStamped& transform) {
  const auto& t = transform.transform.translation;
  const auto& q = transform.transform.rotation;
  return makePose({t.x, t.y, t.z}, Eigen::Quaterniond(q.w, q.x, q.y, q.z));
}

TEST(JointFrames, HangLinksOnTheLinksBeforeThem) {
  const JointFrames frames(arm(), {"shoulder", "slide"});
  EXPECT_THAT(frames.frames(), ElementsAre("arm/upper", "arm/fore", "arm/twin"));
  const auto found = frames.transforms(positions({"shoulder", "slide"}, {0.5, 0.1}));
  ASSERT_THAT(found, SizeIs(3));
  EXPECT_EQ(found[0].header.frame_id, "arm/base");
  EXPECT_TRUE(poseIn(found[0]).isApprox(poseAt(0, 0, 0.2, 0.5)));
  EXPECT_EQ(found[1].header.frame_id, "arm/upper");
  EXPECT_TRUE(poseIn(found[1]).isApprox(poseAt(0.1, 0, 0.5)));
  EXPECT_EQ(found[2].child_frame_id, "arm/twin");
  EXPECT_TRUE(poseIn(found[2]).isApprox(poseAt(1.05, 0, 0))) << "half of 0.1 m from its rest on";
}

TEST(JointFrames, PassOverJointsThatNoMessageHas) {
  const JointFrames frames(arm(), {"slide"});
  const auto found = frames.transforms(positions({"slide"}, {0.1}));
  ASSERT_THAT(found, SizeIs(2));
  EXPECT_EQ(found[0].header.frame_id, "arm/base");
  EXPECT_TRUE(poseIn(found[0]).isApprox(poseAt(0.1, 0, 0.7)));
}

TEST(JointFrames, TakeWhatAMessageHas) {
  const JointFrames frames(arm(), {"shoulder", "slide"});
  EXPECT_THAT(frames.transforms(positions({"shoulder"}, {0.5})), SizeIs(1));
  EXPECT_THAT(frames.transforms(positions({"wheel"}, {0.5})), IsEmpty());
  EXPECT_THAT(frames.transforms(positions({"shoulder", "slide"}, {0.5})), SizeIs(1))
      << "a position is missing";
}

TEST(JointFrames, GoUpwardsFromTheLinkThatTheRobotsFrameNames) {
  JointedRobot robot = arm();
  robot.own_link = 3;
  robot.frame = robot.links[3].frame = "tool";
  const JointFrames frames(robot, {"shoulder", "slide"});
  EXPECT_THAT(frames.frames(), ElementsAre("arm/upper", "arm/base", "arm/twin"));
  const auto found = frames.transforms(positions({"shoulder", "slide"}, {0.5, 0.1}));
  EXPECT_EQ(found[0].header.frame_id, "tool");
  EXPECT_TRUE(poseIn(found[0]).isApprox(poseAt(0.1, 0, 0.5).inverse()));
  EXPECT_TRUE(poseIn(found[1]).isApprox(poseAt(0, 0, 0.2, 0.5).inverse()));
}

TEST(JointFrames, HangOnTheRobotsOriginWhereItsFrameNamesNoLink) {
  JointedRobot robot = arm();
  robot.own_link.reset();
  robot.frame = "arm";
  const auto found = JointFrames(robot, {"shoulder"}).transforms(positions({"shoulder"}, {0.5}));
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].header.frame_id, "arm");
  EXPECT_TRUE(poseIn(found[0]).isApprox(poseAt(0, 0, 0.5, 0.5)));
}

}  // namespace joint_frames_test
}  // namespace synthetic_dataset::motion
