#include "scene/shutter.h"

#include <map>

#include <gtest/gtest.h>

namespace synthetic_dataset::scene {
namespace shutter_test {

using std::chrono::milliseconds;

TEST(Shutter, AnInstantIsOneShotOfTheWholePicture) {
  const auto shots = shotsOf({}, 480);
  ASSERT_EQ(shots.size(), 1U);
  EXPECT_EQ(shots[0].offset, Duration{0});
  EXPECT_EQ(shots[0].row_count, 480);
  EXPECT_EQ(shots[0].weight, 1.0);
}

TEST(Shutter, AnExposureIsSampledInTheMiddleOfEqualParts) {
  const auto shots = shotsOf({milliseconds(40), 4, {}, 1}, 480);
  ASSERT_EQ(shots.size(), 4U);
  EXPECT_EQ(shots[0].offset, milliseconds(-15));
  EXPECT_EQ(shots[1].offset, milliseconds(-5));
  EXPECT_EQ(shots[3].offset, milliseconds(15));
  EXPECT_EQ(shots[3].weight, 0.25);
}

TEST(Shutter, RollingReadsFromTheFirstRowToTheLast) {
  const auto shots = shotsOf({{}, 1, milliseconds(30), 3}, 90);
  ASSERT_EQ(shots.size(), 3U);
  EXPECT_EQ(shots[0].offset, milliseconds(-10));
  EXPECT_EQ(shots[0].first_row, 0);
  EXPECT_EQ(shots[1].offset, milliseconds(0));
  EXPECT_EQ(shots[2].first_row, 60);
}

TEST(Shutter, EveryRowIsExposedOnceInAll) {
  std::map<int, double> weights;
  Duration last = Duration::min();
  for (const Shot& shot : shotsOf({milliseconds(8), 3, milliseconds(20), 7}, 100)) {
    EXPECT_GE(shot.offset, last);
    last = shot.offset;
    for (int row = 0; row < shot.row_count; ++row) weights[shot.first_row + row] += shot.weight;
  }
  ASSERT_EQ(weights.size(), 100U);
  for (const auto& [row, weight] : weights) EXPECT_NEAR(weight, 1.0, 1e-12) << row;
}

TEST(Shutter, HasNoMoreBandsThanRows) {
  EXPECT_EQ(shotsOf({{}, 1, milliseconds(30), 1000}, 90).size(), 90U);
}

}  // namespace shutter_test
}  // namespace synthetic_dataset::scene
