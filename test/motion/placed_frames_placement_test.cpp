#include <gmock/gmock.h>

#include "motion/placed_frames.h"
#include "motion/recorded.h"
#include "support/error_messages.h"

namespace synthetic_dataset::motion {
namespace placement_motion_test {

using test::milliseconds;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(PlacementMotion, HasTheGlobalFrameAlone) {
  const PlacementMotion motion("/map");
  EXPECT_EQ(motion.globalFrame(), "map");
  EXPECT_TRUE(poseOf(motion, "map", milliseconds(1)).matrix() == Pose::Identity().matrix());
  EXPECT_EQ(motion.find("alpha"), std::nullopt);
  EXPECT_EQ(motion.lacks("mop"), "the placement has no frame 'mop'; did you mean 'map'?");
}

TEST(PlacementMotion, HasAsManyTimesAsAreAskedFor) {
  TimelineOptions options = everyMilliseconds(500);
  options.scenes = 3;
  const Timeline timeline = PlacementMotion("map").timeline({"map"}, options);
  EXPECT_THAT(timeline.stamps,
              ElementsAre(milliseconds(500), milliseconds(1000), milliseconds(1500)));
  EXPECT_FALSE(timeline.is_recorded);
}

TEST(PlacementMotion, NamesFramesThatItDoesNotHaveAndTimesBeyondAllClocks) {
  TimelineOptions options = everyMilliseconds(1000 * 1000 * 1000);
  options.scenes = 100000000;
  EXPECT_THAT(test::messagesOf(
                  [&] { static_cast<void>(PlacementMotion("map").timeline({"odom"}, options)); }),
              ElementsAre(HasSubstr("no frame 'odom'"),
                          HasSubstr("scenes: found 100000000, one every 1000000.000000000 s")));
}

}  // namespace placement_motion_test
}  // namespace synthetic_dataset::motion
