#include "plugins/nuscenes/nuscenes_samples.h"

#include <gmock/gmock.h>

namespace synthetic_dataset::nuscenes {
namespace nuscenes_samples_test {

using testing::ElementsAre;

/// Instants of one sensor, one every 100 ms.
class NuScenesSamples : public testing::Test {
 protected:
  NuScenesSamples() {
    dataset_.cameras.push_back(
        {"camera", "lens", CameraModel(640, 480, {500.0, 500.0, 320.0, 240.0}, 0.1, 100.0), false});
    dataset_.motions = {{"walk", 0, 100, 10.0}};
    options_.keyframe_every = 3;
  }

  void add(std::int64_t instant, std::int64_t sequence = 0) {
    Frame frame;
    frame.scene = frame.instant = instant;
    frame.sequence = sequence;
    frames_.push_back(frame);
  }

  /// The instants of a sample's data.
  [[nodiscard]] static std::vector<std::int64_t> instantsOf(const Sample& sample) {
    std::vector<std::int64_t> instants;
    for (const SensorData& each : sample.data) instants.push_back(each.frame->instant);
    return instants;
  }

  DatasetInfo dataset_;
  NuScenesOptions options_;
  std::vector<Frame> frames_;
};

TEST_F(NuScenesSamples, HaveTheSweepsBeforeThemAndTheLastOfAllThoseBehind) {
  for (std::int64_t instant = 0; instant < 8; ++instant) add(instant);
  const Samples samples(dataset_, frames_, options_);
  ASSERT_EQ(samples.all().size(), 3U);
  EXPECT_THAT(instantsOf(*samples.all()[0]), ElementsAre(0));
  EXPECT_THAT(instantsOf(*samples.all()[1]), ElementsAre(1, 2, 3));
  EXPECT_THAT(instantsOf(*samples.all()[2]), ElementsAre(4, 5, 6, 7));
  EXPECT_FALSE(samples.all()[2]->data[1].is_keyframe);
  EXPECT_TRUE(samples.all()[2]->data[2].is_keyframe);
}

TEST_F(NuScenesSamples, KeepSweepsInTheirSequence) {
  add(1, 0);
  add(2, 1);
  add(3, 0);
  add(6, 1);
  const Samples samples(dataset_, frames_, options_);
  ASSERT_EQ(samples.all().size(), 2U);
  EXPECT_THAT(instantsOf(*samples.all()[0]), ElementsAre(1, 3));
  EXPECT_THAT(instantsOf(*samples.all()[1]), ElementsAre(2, 6));
  EXPECT_EQ(samples.all()[1]->data[1].prev, dataToken(dataset_, frames_[1]));
  EXPECT_EQ(samples.all()[1]->prev, "");
}

TEST_F(NuScenesSamples, HaveNothingOfASequenceWithoutKeyframe) {
  add(1);
  add(2);
  EXPECT_TRUE(Samples(dataset_, frames_, options_).all().empty());
}

}  // namespace nuscenes_samples_test
}  // namespace synthetic_dataset::nuscenes
