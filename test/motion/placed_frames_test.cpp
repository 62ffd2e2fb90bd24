#include "motion/placed_frames.h"

#include <memory>
#include <optional>

#include <gmock/gmock.h>

#include "motion/recorded.h"
#include "support/fake_frame_source.h"

namespace synthetic_dataset::motion {
namespace placed_frames_test {

using test::FakeFrameSource;
using test::milliseconds;
using test::poseAt;
using ::testing::SizeIs;

/// Placed frames over a source in which alpha drives along x until 2 s and `hall` stands still.
PlacedFrames placedOverMotion() {
  const auto alpha = [](Stamp time) -> std::optional<Pose> {
    if (time > milliseconds(2000)) return std::nullopt;
    return poseAt(toSeconds(time), 0, 0);
  };
  return PlacedFrames(
      std::make_shared<FakeFrameSource>(std::map<std::string, FakeFrameSource::PoseAt>{
          {"alpha/base_link", alpha}, {"hall", FakeFrameSource::fixed(poseAt(0, 4, 0))}}));
}

void expectAt(const FrameSource& source, const std::string& frame, Stamp time, double x, double y) {
  ASSERT_TRUE(isKnown(source, frame, time)) << frame;
  EXPECT_TRUE(poseOf(source, frame, time).translation().isApprox(Eigen::Vector3d(x, y, 0), 1e-9))
      << frame;
}

TEST(PlacedFrames, HaveTheirPosesAtAnyTime) {
  PlacedFrames frames = placedOverMotion();
  const Pose X_GF = poseAt(1, 2, 3, 0.4);
  frames.place("bravo", X_GF);
  for (const Stamp time : {Stamp(0), milliseconds(1500), milliseconds(1'000'000'000)}) {
    EXPECT_TRUE(poseOf(frames, "bravo", time).matrix() == X_GF.matrix());
  }
  EXPECT_TRUE(frames.isPlaced("/bravo"));
}

TEST(PlacedFrames, AreWhereTheyWerePlacedLast) {
  PlacedFrames frames = placedOverMotion();
  const FrameId bravo = frames.place("/bravo", poseAt(1, 0, 0));
  frames.place("charlie", poseAt(2, 0, 0));
  frames.place(bravo, poseAt(3, 0, 0));
  expectAt(frames, "bravo", milliseconds(1), 3, 0);
  expectAt(frames, "//charlie", milliseconds(1), 2, 0);
}

TEST(PlacedFrames, AreNotKnownWhileTheyAreNotThere) {
  PlacedFrames frames = placedOverMotion();
  const FrameId bravo = frames.place("bravo", std::nullopt);
  EXPECT_TRUE(frames.isPlaced("bravo"));
  EXPECT_FALSE(isKnown(frames, "bravo", milliseconds(1)));
  frames.place(bravo, poseAt(1, 0, 0));
  expectAt(frames, "bravo", milliseconds(1), 1, 0);
  frames.place(bravo, std::nullopt);
  EXPECT_FALSE(isKnown(frames, "bravo", milliseconds(1)));
}

TEST(PlacedFrames, AreNotThereWhateverTheirSourceSays) {
  PlacedFrames frames = placedOverMotion();
  frames.place("alpha/base_link", std::nullopt);
  EXPECT_FALSE(isKnown(frames, "alpha/base_link", milliseconds(1250)));
}

TEST(PlacedFrames, LeaveAllOthersToTheirSource) {
  PlacedFrames frames = placedOverMotion();
  frames.place("bravo", poseAt(1, 0, 0));
  expectAt(frames, "alpha/base_link", milliseconds(1250), 1.25, 0);
  expectAt(frames, "hall", milliseconds(1250), 0, 4);
  EXPECT_FALSE(isKnown(frames, "alpha/base_link", milliseconds(2500)));
  EXPECT_FALSE(frames.isPlaced("alpha/base_link"));
  EXPECT_EQ(frames.find("haul"), std::nullopt);
  EXPECT_EQ(frames.lacks("haul"), "the fake has no frame 'haul'; did you mean 'hall'?");
}

TEST(PlacedFrames, CoverThoseOfTheirSource) {
  PlacedFrames frames = placedOverMotion();
  frames.place("alpha/base_link", poseAt(7, 7, 0));
  expectAt(frames, "alpha/base_link", milliseconds(1250), 7, 7);
  expectAt(frames, "alpha/base_link", milliseconds(9999), 7, 7);
  expectAt(frames, "hall", milliseconds(1250), 0, 4);
}

TEST(PlacedFrames, StayInACopyWhereTheyWere) {
  PlacedFrames frames = placedOverMotion();
  const FrameId bravo = frames.place("bravo", poseAt(1, 0, 0));
  const PlacedFrames before = frames;
  frames.place(bravo, poseAt(2, 0, 0));
  expectAt(before, "bravo", milliseconds(1), 1, 0);
  expectAt(frames, "bravo", milliseconds(1), 2, 0);
}

TEST(PlacedFrames, DoNotLimitTheTimesOfScenes) {
  PlacedFrames frames(std::make_shared<BagMotion>(
      recorded([](test::BagBuilder& bag) { moveAlongX(bag, "map", "alpha", 1000, 2000); })));
  frames.place("bravo", poseAt(1, 0, 0));
  EXPECT_THAT(frames.timeline({"alpha", "bravo"}, everyMilliseconds(500)).stamps, SizeIs(2));
}

}  // namespace placed_frames_test
}  // namespace synthetic_dataset::motion
