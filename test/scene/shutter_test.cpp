#include "scene/shutter.h"

#include <gtest/gtest.h>

namespace synthetic_dataset::scene {
namespace shutter_test {

using std::chrono::milliseconds;

TEST(Shutter, AnInstantIsOneShotOfTheWholePicture) {
  const auto shots = shotsOf({}, 480);
  ASSERT_EQ(shots.size(), 1U);
  ASSERT_EQ(shots[0].moments.size(), 1U);
  EXPECT_EQ(shots[0].moments[0].offset, Duration{0});
  EXPECT_FALSE(shots[0].rolls());
  EXPECT_EQ(shots[0].weight, 1.0);
}

TEST(Shutter, AnExposureIsSampledInTheMiddleOfEqualParts) {
  const auto shots = shotsOf({milliseconds(40), 4, {}, 1}, 480);
  ASSERT_EQ(shots.size(), 4U);
  EXPECT_EQ(shots[0].moments[0].offset, milliseconds(-15));
  EXPECT_EQ(shots[1].moments[0].offset, milliseconds(-5));
  EXPECT_EQ(shots[3].moments[0].offset, milliseconds(15));
  EXPECT_EQ(shots[3].weight, 0.25);
}

TEST(Shutter, RollingReadsFromTheFirstRowToTheLast) {
  const auto shots = shotsOf({{}, 1, milliseconds(30), 3}, 90);
  ASSERT_EQ(shots.size(), 1U);
  EXPECT_TRUE(shots[0].rolls());
  const auto& moments = shots[0].moments;
  ASSERT_EQ(moments.size(), 4U) << "the borders of three bands";
  EXPECT_EQ(moments[0].offset, milliseconds(-15));
  EXPECT_EQ(moments[0].row, -0.5);
  EXPECT_EQ(moments[1].offset, milliseconds(-5));
  EXPECT_EQ(moments[1].row, 29.5);
  EXPECT_EQ(moments[3].offset, milliseconds(15));
  EXPECT_EQ(moments[3].row, 89.5);
}

TEST(Shutter, EachSampleOfAnExposureRolls) {
  double weight = 0.0;
  Duration last = Duration::min();
  for (const Shot& shot : shotsOf({milliseconds(9), 3, milliseconds(20), 7}, 100)) {
    weight += shot.weight;
    ASSERT_EQ(shot.moments.size(), 8U);
    EXPECT_GT(shot.moments.front().offset, last) << "in the order of their times";
    last = shot.moments.front().offset;
    EXPECT_EQ(shot.moments.back().offset - shot.moments.front().offset, milliseconds(20));
  }
  EXPECT_NEAR(weight, 1.0, 1e-12);
}

TEST(Shutter, HasNoMoreBandsThanRows) {
  EXPECT_EQ(shotsOf({{}, 1, milliseconds(30), 1000}, 90)[0].moments.size(), 91U);
}

}  // namespace shutter_test
}  // namespace synthetic_dataset::scene
