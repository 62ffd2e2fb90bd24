#include "motion/tf/pose_topics.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/recorded.h"
#include "support/error_messages.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::motion {
namespace pose_topics_test {

using test::BagBuilder;
using test::milliseconds;
using test::poseAt;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class PoseTopicsTest : public ::testing::Test {
 protected:
  BagMotion read(const std::vector<std::string>& frames) {
    options.bag_files = {bag.close()};
    options.frames = frames;
    return BagMotion(options);
  }

  /// Calls `write` once a second, with a pose whose x is the time in seconds.
  template <class Write>
  void eachSecond(const Write& write) {
    for (int i = 1; i <= 5; ++i) write(milliseconds(1000 * i), poseAt(i, 0, 0));
  }

  static double xAt(const BagMotion& motion, const std::string& frame, std::int64_t ms) {
    return poseOf(motion, frame, milliseconds(ms)).translation().x();
  }

  test::TemporaryFolder folder;
  BagBuilder bag{folder / "recorded.bag"};
  BagMotionOptions options;
};

TEST_F(PoseTopicsTest, OdometryMovesAFrameThatTfLacks) {
  eachSecond(
      [&](Stamp stamp, const Pose& pose) { bag.drive("/odom", "odom", "base_link", stamp, pose); });
  options.global_frame = "odom";
  const BagMotion motion = read({"base_link"});
  EXPECT_DOUBLE_EQ(xAt(motion, "base_link", 2500), 2.5);
  EXPECT_THAT(warningsOf(motion, {"base_link"}),
              Contains(HasSubstr("TF does not connect the frame 'base_link' with 'odom': its "
                                 "poses come from the topic /odom (nav_msgs/Odometry)")));
}

TEST_F(PoseTopicsTest, OdometryJoinsTreesOfTf) {
  bag.fix("map", "odom", milliseconds(1000), poseAt(100, 0, 0));
  bag.fix("base_link", "camera", milliseconds(1000), poseAt(0.5, 0, 0));
  eachSecond(
      [&](Stamp stamp, const Pose& pose) { bag.drive("/odom", "odom", "base_link", stamp, pose); });
  EXPECT_DOUBLE_EQ(xAt(read({"camera"}), "camera", 2500), 103.0);
}

TEST_F(PoseTopicsTest, OdometryDoesNotDoubleWhatTfHas) {
  eachSecond([&](Stamp stamp, const Pose& pose) {
    bag.move("map", "base_link", stamp, pose);
    bag.drive("/odom", "map", "base_link", stamp, poseAt(-9, 0, 0));
  });
  const BagMotion motion = read({"base_link", "cup"});
  EXPECT_DOUBLE_EQ(xAt(motion, "base_link", 2500), 2.5);
  EXPECT_THAT(warningsOf(motion, {"base_link"}), IsEmpty());
}

TEST_F(PoseTopicsTest, NamesTheGlobalFrameThatWouldDo) {
  eachSecond(
      [&](Stamp stamp, const Pose& pose) { bag.drive("/odom", "odom", "base_link", stamp, pose); });
  const BagMotion motion = read({"base_link"});
  EXPECT_THAT(
      test::messagesOf(
          [&] { static_cast<void>(motion.timeline({"base_link"}, everyMilliseconds(500))); }),
      Contains(AllOf(HasSubstr("global frame 'map' is not in the recording"),
                     HasSubstr("nothing says where it is"), HasSubstr("`global_frame: odom`"))));
}

TEST_F(PoseTopicsTest, AsksWhichOfTwoTopicsCounts) {
  eachSecond([&](Stamp stamp, const Pose& pose) {
    bag.drive("/odom", "odom", "base_link", stamp, pose);
    bag.drive("/odometry/filtered", "odom", "base_link", stamp, poseAt(0, 7, 0));
  });
  bag.move("odom", "other", milliseconds(1000));
  options.global_frame = "odom";
  options.bag_files = {bag.close()};
  options.frames = {"base_link"};
  const BagMotion undecided(options);
  EXPECT_THAT(test::messagesOf([&] {
                static_cast<void>(undecided.timeline({"base_link"}, everyMilliseconds(500)));
              }),
              Contains(AllOf(HasSubstr("several topics give the frame 'base_link': /odom, "
                                       "/odometry/filtered"),
                             HasSubstr("pose_topics: [/odom]"))));
  options.pose_topics = {{"/odometry/filtered", std::nullopt, std::nullopt}};
  const BagMotion decided(options);
  EXPECT_DOUBLE_EQ(poseOf(decided, "base_link", milliseconds(2500)).translation().y(), 7.0);
}

TEST_F(PoseTopicsTest, ASettingNamesTheFrameOfAPose) {
  eachSecond([&](Stamp stamp, const Pose& pose) { bag.locate("/vicon/cup", "map", stamp, pose); });
  bag.move("map", "table", milliseconds(1000));
  options.pose_topics = {{"vicon/cup", "cup", std::nullopt}};
  EXPECT_DOUBLE_EQ(xAt(read({"cup"}), "cup", 2500), 2.5);
}

TEST_F(PoseTopicsTest, TheOnlyPoseOfARecordingNeedsNoName) {
  eachSecond([&](Stamp stamp, const Pose& pose) { bag.locate("/vicon/cup", "map", stamp, pose); });
  const BagMotion motion = read({"cup/body"});
  EXPECT_DOUBLE_EQ(xAt(motion, "cup/body", 2500), 2.5);
  EXPECT_THAT(warningsOf(motion, {"cup/body"}), Contains(HasSubstr("/vicon/cup")));
}

TEST_F(PoseTopicsTest, APoseBesideTfMovesNothingUnasked) {
  eachSecond([&](Stamp stamp, const Pose& pose) {
    bag.move("map", "table", stamp, pose);
    bag.locate("/goal", "map", stamp, pose);
  });
  EXPECT_FALSE(read({"cup"}).find("cup").has_value());
}

TEST_F(PoseTopicsTest, GazebosModelsAreFramesOfTheirNames) {
  eachSecond([&](Stamp stamp, const Pose& pose) {
    bag.simulate("/gazebo/model_states", "gazebo_msgs/ModelStates", stamp,
                 {{"ground_plane", Pose::Identity()}, {"rover", pose}});
  });
  options.global_frame = "world";
  EXPECT_DOUBLE_EQ(xAt(read({"rover"}), "rover", 2500), 2.5);
}

TEST_F(PoseTopicsTest, GazebosLinksAreFramesBelowTheirModels) {
  eachSecond([&](Stamp stamp, const Pose& pose) {
    bag.simulate("/gazebo/link_states", "gazebo_msgs/LinkStates", stamp,
                 {{"rover::base_link", pose}});
  });
  options.global_frame = "world";
  EXPECT_DOUBLE_EQ(xAt(read({"rover/base_link"}), "rover/base_link", 2500), 2.5);
}

TEST_F(PoseTopicsTest, SaysWhatIsWrongWithANamedTopic) {
  bag.move("map", "table", milliseconds(1000)).say("/chatter", milliseconds(1000));
  bag.locate("/vicon/cup", "map", milliseconds(1000), poseAt(0, 0, 0));
  bag.bend("/joint_states", milliseconds(1000), {{"elbow", 0.0}});
  options.bag_files = {bag.close()};
  options.pose_topics = {{"/chatter", std::nullopt, std::nullopt},
                         {"/vicon/cup", std::nullopt, std::nullopt},
                         {"/vicon/cap", "cup", std::nullopt},
                         {"/joint_states", std::nullopt, "arm"}};
  EXPECT_THAT(
      test::messagesOf([&] { static_cast<void>(BagMotion(options)); }),
      ElementsAre(
          AllOf(HasSubstr("pose_topics: found '/chatter', whose messages are std_msgs/String"),
                HasSubstr("nav_msgs/Odometry")),
          HasSubstr("{topic: /vicon/cup, frame: NAME} does"),
          AllOf(HasSubstr("a topic that the recording does not have"),
                HasSubstr("did you mean '/vicon/cup'?")),
          HasSubstr("no object 'arm' whose model has joints")));
}

TEST_F(PoseTopicsTest, TheOnlyNamespaceWithTfIsTaken) {
  for (const std::string topic : {"/robot1/tf", "/robot1/tf_static"}) {
    BagBuilder::Transform transform;
    transform.topic = topic;
    transform.parent = "map";
    transform.child = topic == "/robot1/tf" ? "base_link" : "wall";
    transform.stamp = transform.recorded = milliseconds(1000);
    bag.add(transform);
  }
  const BagMotion motion = read({"base_link"});
  EXPECT_TRUE(isKnown(motion, "wall", milliseconds(9000))) << "static";
  EXPECT_TRUE(isKnown(motion, "base_link", milliseconds(1000)));
  EXPECT_THAT(warningsOf(motion, {"base_link"}),
              Contains(HasSubstr("TF is taken from /robot1/tf")));
}

TEST_F(PoseTopicsTest, OneOfSeveralNamespacesHasToBeNamed) {
  for (const std::string topic : {"/robot1/tf", "/robot2/tf"}) {
    BagBuilder::Transform transform;
    transform.topic = topic;
    transform.parent = "map";
    transform.child = topic.substr(1, 6);
    transform.stamp = transform.recorded = milliseconds(1000);
    bag.add(transform);
  }
  options.bag_files = {bag.close()};
  EXPECT_THAT(test::messagesOf([&] { static_cast<void>(BagMotion(options)); }),
              ElementsAre(AllOf(HasSubstr("/robot1/tf, /robot2/tf"),
                                HasSubstr("tf_topics: [/robot1/tf]"))));
  options.tf_topics = {"/robot2/tf"};
  const BagMotion motion(options);
  EXPECT_TRUE(motion.find("robot2").has_value());
  EXPECT_FALSE(motion.find("robot1").has_value());
}

TEST_F(PoseTopicsTest, ThePosesOfAnArrayMoveNumberedFrames) {
  eachSecond([&](Stamp stamp, const Pose& pose) {
    bag.locateAll("/people", "map", stamp, {poseAt(0, 3, 0), pose});
  });
  options.pose_topics = {{"/people", "person", std::nullopt}};
  const BagMotion motion = read({"person_1"});
  EXPECT_DOUBLE_EQ(xAt(motion, "person_1", 2500), 2.5);
  EXPECT_DOUBLE_EQ(poseOf(motion, "person_0", milliseconds(2500)).translation().y(), 3.0);
}

TEST_F(PoseTopicsTest, AWheelTurnsAsFarAsItsAngleSays) {
  const auto spokeAt = [&](const std::vector<double>& angles) {
    const test::TemporaryFolder place;
    BagBuilder wheel(place / "wheel.bag");
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const Stamp stamp = milliseconds(1000 + 1000 * static_cast<std::int64_t>(i));
      wheel.move("map", "base", stamp, poseAt(0, 0, 0));
      wheel.bend("/joint_states", stamp, {{"axle", angles[i]}});
    }
    BagMotionOptions of_wheel;
    of_wheel.bag_files = {wheel.close()};
    of_wheel.robots = [] {
      JointedRobot robot{"wheel", "base", 0, {}};
      robot.links = {JointedLink{"base"},
                     JointedLink{"spoke", 0, poseAt(0, 0, 0), "axle", false, {0, 0, 1}}};
      return std::vector<JointedRobot>{robot};
    };
    const BagMotion motion(of_wheel);
    const Eigen::Matrix3d R = poseOf(motion, "spoke", milliseconds(1500)).linear();
    return std::atan2(R(1, 0), R(0, 0));
  };
  EXPECT_NEAR(spokeAt({0.0, 4.0, 8.0}), 2.0, 1e-9) << "more than half a turn between two";
  EXPECT_NEAR(spokeAt({0.0, -5.0, -10.0}), -2.5, 1e-9);
  EXPECT_NEAR(std::abs(spokeAt({3.1, -3.1})), M_PI, 1e-9) << "it only begins to count anew";
}

}  // namespace pose_topics_test
}  // namespace synthetic_dataset::motion
