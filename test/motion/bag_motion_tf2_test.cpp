// BagMotion compared with a tf2 buffer that is fed the same data by hand.
#include <cstring>
#include <random>

#include <console_bridge/console.h>
#include <geometry_msgs/TransformStamped.h>
#include <gtest/gtest.h>
#include <tf2/buffer_core.h>

#include "motion/recorded.h"

namespace synthetic_dataset::motion {
namespace bag_motion_tf2_test {

using test::BagBuilder;

constexpr std::int64_t kEpoch = 1650000000000000000;
constexpr int kFrames = 7;
constexpr int kTransforms = 300;
constexpr std::int64_t kSpan = 1000;  // [ns]: few stamps, so that many coincide

std::string frameName(int i) { return "frame" + std::to_string(i); }

/// Transforms among a few frames that change their parents, come late, repeat stamps, become static
/// and form loops: all that a recording can hold.
class RandomRecording {
 public:
  explicit RandomRecording(unsigned seed) : random_(seed) {
    for (int i = 0; i < kTransforms; ++i) {
      BagBuilder::Transform transform;
      const int child = upTo(kFrames - 1);
      // Mostly upwards, so that there are long chains; sometimes downwards.
      const int parent = upTo(9) == 0 ? upTo(kFrames - 1) : std::max(0, child - 1 - upTo(1));
      if (parent == child) continue;
      const bool is_static = child == kFrames - 1 && upTo(3) == 0;
      if (has_static_ && child == kFrames - 1)
        continue;  // a static frame's later values are another matter
      has_static_ = has_static_ || is_static;
      transform.topic = is_static ? "/tf_static" : "/tf";
      transform.parent = frameName(parent);
      transform.child = frameName(child);
      transform.stamp = randomTime();
      transform.recorded = Stamp(kEpoch + i);
      const Eigen::Quaterniond q =
          Eigen::Quaterniond(real(), real(), real(), real() + 2.0).normalized();
      transform.x = real();
      transform.y = real();
      transform.z = real();
      transform.qx = q.x();
      transform.qy = q.y();
      transform.qz = q.z();
      transform.qw = q.w();
      transforms_.push_back(transform);
    }
  }

  void write(BagBuilder& bag) const {
    for (const auto& transform : transforms_) bag.add(transform);
  }

  void feed(tf2::BufferCore& buffer) const {
    for (const auto& transform : transforms_) {
      geometry_msgs::TransformStamped stamped;
      stamped.header.frame_id = transform.parent;
      stamped.header.stamp.fromNSec(static_cast<std::uint64_t>(transform.stamp.count()));
      stamped.child_frame_id = transform.child;
      stamped.transform.translation.x = transform.x;
      stamped.transform.translation.y = transform.y;
      stamped.transform.translation.z = transform.z;
      stamped.transform.rotation.x = transform.qx;
      stamped.transform.rotation.y = transform.qy;
      stamped.transform.rotation.z = transform.qz;
      stamped.transform.rotation.w = transform.qw;
      buffer.setTransform(stamped, "test", transform.topic == "/tf_static");
    }
  }

  Stamp randomTime() { return Stamp(kEpoch + upTo(kSpan)); }
  std::string randomFrame() { return frameName(upTo(kFrames - 1)); }

 private:
  int upTo(int largest) { return std::uniform_int_distribution<int>(0, largest)(random_); }
  double real() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }

  std::mt19937 random_;
  bool has_static_ = false;
  std::vector<BagBuilder::Transform> transforms_;
};

/// Compares to the last bit.
void expectSameTransform(const BagMotion& motion, const tf2::BufferCore& buffer,
                         const std::string& frame, Stamp time) {
  ros::Time ros_time;
  ros_time.fromNSec(static_cast<std::uint64_t>(time.count()));
  const std::string& target = motion.globalFrame();
  const bool known = buffer.canTransform(target, frame, ros_time);
  ASSERT_EQ(isKnown(motion, frame, time), known)
      << frame << " -> " << target << " at " << time.count() - kEpoch;
  if (!known) return;
  const auto expected = buffer.lookupTransform(target, frame, ros_time).transform;
  const auto& t = expected.translation;
  const auto& q = expected.rotation;
  const Pose X_TF = makePose({t.x, t.y, t.z}, Eigen::Quaterniond(q.w, q.x, q.y, q.z));
  EXPECT_EQ(std::memcmp(poseOf(motion, frame, time).data(), X_TF.data(), 12 * sizeof(double)), 0)
      << frame << " -> " << target << " at " << time.count() - kEpoch;
}

class BagMotionTf2Test : public ::testing::TestWithParam<unsigned> {
 protected:
  // The reference buffer logs each repeated stamp.
  BagMotionTf2Test() { console_bridge::noOutputHandler(); }
  ~BagMotionTf2Test() override { console_bridge::restorePreviousOutputHandler(); }
};

TEST_P(BagMotionTf2Test, AnswersAsABufferFedInRecordOrder) {
  RandomRecording recording(GetParam());
  tf2::BufferCore buffer(ros::Duration(1000.0));
  recording.feed(buffer);
  for (int target = 0; target < kFrames; ++target) {
    const BagMotion motion =
        recorded([&](BagBuilder& bag) { recording.write(bag); }, frameName(target));
    for (int i = 0; i < 300; ++i) {
      expectSameTransform(motion, buffer, recording.randomFrame(), recording.randomTime());
      if (HasFatalFailure()) return;
    }
  }
}

TEST_P(BagMotionTf2Test, FindsTheTimelineThatAScanWithTf2Finds) {
  RandomRecording recording(GetParam());
  tf2::BufferCore buffer(ros::Duration(1000.0));
  recording.feed(buffer);
  const std::vector<std::string> frames = {frameName(5), frameName(3)};
  const std::string global = frameName(1);
  const auto write = [&](BagBuilder& bag) {
    recording.write(bag);
    bag.say("/end", Stamp(kEpoch + kSpan));
  };
  const BagMotion motion = recorded(write, global);
  const Duration period(7);
  const auto all_known = [&](Stamp time) {
    ros::Time ros_time;
    ros_time.fromNSec(static_cast<std::uint64_t>(time.count()));
    return buffer.canTransform(global, frames[0], ros_time) &&
           buffer.canTransform(global, frames[1], ros_time);
  };
  Stamp start = motion.times().start;
  Stamp end = motion.times().end;
  while (start < motion.times().end && !all_known(start)) start += period;
  while (end > start && !all_known(end)) end -= period;
  std::vector<Stamp> expected;
  std::int64_t unknown = 0;
  for (Stamp time = start; time < end; time += period) {
    if (all_known(time)) {
      expected.push_back(time);
    } else {
      ++unknown;
    }
  }

  TimelineOptions options;
  options.period = period;
  if (expected.empty()) {
    EXPECT_THROW(static_cast<void>(motion.timeline(frames, options)), std::runtime_error);
    return;
  }
  const Timeline timeline = motion.timeline(frames, options);
  EXPECT_EQ(timeline.stamps, expected);
  EXPECT_EQ(timeline.left_out_unknown, unknown);
}

INSTANTIATE_TEST_SUITE_P(Seeds, BagMotionTf2Test, ::testing::Range(0U, 12U));

}  // namespace bag_motion_tf2_test
}  // namespace synthetic_dataset::motion
