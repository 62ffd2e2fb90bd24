#include <chrono>
#include <cstdint>

#include <gmock/gmock.h>

#include "motion/tf/stretches.h"

namespace synthetic_dataset::motion {
namespace lone_steps_test {

using std::chrono::seconds;
using ::testing::ElementsAre;

/// A transform a second, recorded from 100 s on.
class LoneStepsTest : public ::testing::Test {
 protected:
  void add(std::int64_t stamp) {
    const Stamp recorded = seconds(100 + static_cast<std::int64_t>(transforms_.size()));
    transforms_.push_back({seconds(stamp), recorded, arrivalOf(transforms_.size())});
  }

  [[nodiscard]] static Arrival arrivalOf(std::size_t index) {
    return {seconds(100 + static_cast<std::int64_t>(index)), 0, index};
  }

  std::vector<TimedTransform> transforms_;
};

TEST_F(LoneStepsTest, TransformsOfAnotherClockDoNotCount) {
  // The sensor's clock was four seconds ahead until it was set.
  for (const std::int64_t stamp : {104, 105, 106, 107, 104, 105, 106}) add(stamp);
  EXPECT_THAT(withoutMixedTimes(transforms_, {arrivalOf(4)}, seconds(0)), ElementsAre(4, 5, 6));
}

TEST_F(LoneStepsTest, OfTheRightClockComeFirstWhereItWasSetWrong) {
  for (const std::int64_t stamp : {100, 101, 102, 103, 94, 95, 96}) add(stamp);
  EXPECT_THAT(withoutMixedTimes(transforms_, {arrivalOf(4)}, seconds(0)), ElementsAre(0, 1, 2, 3));
}

TEST_F(LoneStepsTest, TheClockIsThatOfTheWholeRecording) {
  for (const std::int64_t stamp : {4, 5, 6, 7, 0, 1, 2}) add(stamp);
  EXPECT_THAT(withoutMixedTimes(transforms_, {arrivalOf(4)}, seconds(96)), ElementsAre(0, 1, 2, 3));
}

TEST_F(LoneStepsTest, WhatIsSentAgainTakesThePlaceOfWhatWasSentBefore) {
  // None of the parts has the recording's clock; the second part comes nearest.
  for (const std::int64_t stamp : {50, 51, 52, 60, 61, 62, 40, 41, 42}) add(stamp);
  EXPECT_THAT(withoutMixedTimes(transforms_, {arrivalOf(3), arrivalOf(6)}, seconds(0)),
              ElementsAre(3, 4, 5));
}

TEST_F(LoneStepsTest, PartsOfOneClockFollowOneAnother) {
  const auto half = std::chrono::milliseconds(500);
  for (const std::int64_t stamp : {100, 101, 102, 103}) add(stamp);
  for (const std::int64_t stamp : {102, 103, 104}) {
    transforms_.push_back({seconds(stamp), seconds(stamp) + half, arrivalOf(transforms_.size())});
  }
  EXPECT_THAT(withoutMixedTimes(transforms_, {arrivalOf(4)}, seconds(0)),
              ElementsAre(0, 1, 4, 5, 6));
}

}  // namespace lone_steps_test
}  // namespace synthetic_dataset::motion
