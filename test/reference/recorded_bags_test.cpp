/// Recordings of real robots, made by others.

#include <gtest/gtest.h>

#include "motion/bag_motion.h"
#include "reference/reference_folder.h"

namespace synthetic_dataset {
namespace recorded_bags_test {

TEST(RecordedBags, AJackalsRunIsReplayed) {
  const motion::BagMotion recording({(test::referenceFolder() / "bags/jackal.bag").string()},
                                    "map");
  motion::TimelineOptions options;
  options.period = motion::periodOf(2.0);
  const motion::Timeline timeline = recording.timeline({"jackal/base_link"}, options);
  EXPECT_NEAR(static_cast<double>(timeline.stamps.size()), 61.18 * 2.0, 2.0);
  // The robot drove: its poses change, and smoothly.
  double length = 0.0;
  const motion::FrameId base = *recording.find("jackal/base_link");
  Pose last = recording.knownPose(base, timeline.stamps.front());
  for (const Stamp stamp : timeline.stamps) {
    const Pose now = recording.knownPose(base, stamp);
    const double step = (now.translation() - last.translation()).norm();
    EXPECT_LT(step, 1.5) << "faster than 3 m/s";
    length += step;
    last = now;
  }
  EXPECT_GT(length, 5.0);
}

}  // namespace recorded_bags_test
}  // namespace synthetic_dataset
