#include "motion/bag_contents.h"

#include <algorithm>
#include <stdexcept>

#include <gmock/gmock.h>

#include "support/bag_builder.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::motion {
namespace bag_contents_test {

using test::BagBuilder;
using test::milliseconds;
using test::poseAt;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A robot that stands, drives 4 m along x and stands again, with a camera on it, over 20 s.
class BagContentsTest : public ::testing::Test {
 protected:
  BagContentsTest() {
    BagBuilder bag(folder / "a.bag");
    bag.fix("jackal/base_link", "jackal/eye_optical", milliseconds(1000), poseAt(0, 0, 0.5));
    for (int i = 0; i <= 200; ++i) {
      const double x = 0.04 * std::clamp(i - 50, 0, 100);
      const Stamp stamp = milliseconds(1000 + 100 * i);
      bag.add({"/tf", "odom", "jackal/base_link", stamp, stamp, x, 0, 0, 0, 0, 0, 1, "/ekf"});
      if (i < 10 || i > 190) bag.move("map", "odom", stamp, poseAt(1, 2, 0));
    }
    bag.calibrate("/eye/camera_info", "jackal/eye_optical", milliseconds(1000), 140);
    contents = readContents({bag.close()});
  }

  [[nodiscard]] const RecordedFrame& frame(const std::string& name) const {
    for (const RecordedFrame& each : contents.frames) {
      if (each.name == name) return each;
    }
    throw std::runtime_error("no frame " + name);
  }

  test::TemporaryFolder folder;
  BagContents contents;
};

TEST_F(BagContentsTest, HasFramesWithParentsRatesTimesAndPublishers) {
  const RecordedFrame& base = frame("jackal/base_link");
  EXPECT_THAT(base.parents, ElementsAre("odom"));
  EXPECT_EQ(base.root, "map");
  EXPECT_FALSE(base.is_static);
  EXPECT_EQ(base.count, 201);
  EXPECT_EQ(base.period, milliseconds(100));
  EXPECT_EQ(base.first, milliseconds(1000));
  EXPECT_EQ(base.last, milliseconds(21000));
  EXPECT_EQ(base.gap_count, 0);
  EXPECT_THAT(base.publishers, ElementsAre("/ekf"));
  EXPECT_TRUE(frame("jackal/eye_optical").is_static);
}

TEST_F(BagContentsTest, HasWhereAndWhenFramesTravel) {
  const RecordedFrame& base = frame("jackal/base_link");
  EXPECT_NEAR(base.extent.x(), 4.0, 0.01);
  EXPECT_NEAR(base.extent.y(), 0.0, 1e-9);
  EXPECT_TRUE(base.middle_R.isApprox(Eigen::Vector3d(3, 2, 0), 0.01)) << "in the root's frame";
  EXPECT_NEAR(toSeconds(base.moves_from), 6.0, 0.1);
  EXPECT_NEAR(toSeconds(base.moves_until), 16.0, 0.1);
  EXPECT_NEAR(base.path_length, 4.0, 0.05);
  EXPECT_NEAR(frame("odom").extent.norm(), 0.0, 1e-9);
  EXPECT_EQ(frame("odom").path_length, 0.0);
}

TEST_F(BagContentsTest, HasGaps) {
  EXPECT_EQ(frame("odom").gap_count, 1);
  EXPECT_EQ(frame("odom").longest_gap, milliseconds(18200));
}

TEST_F(BagContentsTest, HasCameras) {
  ASSERT_EQ(contents.cameras.size(), 1U);
  EXPECT_EQ(contents.cameras[0].topic, "/eye/camera_info");
  EXPECT_EQ(contents.cameras[0].frame, "jackal/eye_optical");
  EXPECT_EQ(contents.cameras[0].width, 160);
  EXPECT_THAT(cameraFrames(contents), ElementsAre("jackal/eye_optical"));
}

TEST_F(BagContentsTest, GuessesRobotsByTheirFramesNames) {
  const std::vector<RobotFrame> robots = robotFrames(contents);
  ASSERT_EQ(robots.size(), 1U);
  EXPECT_EQ(robots[0].name, "jackal");
  EXPECT_EQ(robots[0].prefix, "jackal");
  EXPECT_EQ(robots[0].frame, "jackal/base_link");
}

TEST(BagContents, WithoutTransformsHaveTopicsAlone) {
  const test::TemporaryFolder folder;
  BagBuilder bag(folder / "a.bag");
  bag.say("/chatter", milliseconds(1000));
  const BagContents contents = readContents({bag.close()});
  EXPECT_THAT(contents.frames, IsEmpty());
  ASSERT_EQ(contents.topics.size(), 1U);
  EXPECT_EQ(contents.topics[0].name, "/chatter");
  EXPECT_THAT(robotFrames(contents), IsEmpty());
}

TEST(BagContents, TakeWhatMovesForARobotWhereNoFrameIsNamedLikeOne) {
  const test::TemporaryFolder folder;
  BagBuilder bag(folder / "a.bag");
  for (int i = 0; i <= 10; ++i) {
    bag.move("world", "firefly", milliseconds(1000 + 100 * i), poseAt(0.1 * i, 0, 1));
    bag.move("world", "post", milliseconds(1000 + 100 * i), poseAt(5, 0, 0));
  }
  const std::vector<RobotFrame> robots = robotFrames(readContents({bag.close()}));
  ASSERT_EQ(robots.size(), 1U);
  EXPECT_EQ(robots[0].name, "firefly");
}

}  // namespace bag_contents_test
}  // namespace synthetic_dataset::motion
