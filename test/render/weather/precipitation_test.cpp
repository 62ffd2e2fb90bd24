#include "render/weather/precipitation.h"

#include <cmath>

#include <gtest/gtest.h>

namespace synthetic_dataset::render {
namespace precipitation_test {

/// The rain of an hour on the ground [mm], from the drops in 400 m^3 and their speeds.
double hourOf(const Precipitation& rain) {
  constexpr int kCells = 400;
  double flow = 0.0;  // [m^3/s] through a square metre, summed over the cells
  for (int i = 0; i < kCells; ++i) {
    for (const Drop& drop : rain.in({i, 3, -7}, 2e-4, 5)) {
      flow += M_PI / 6.0 * std::pow(drop.diameter, 3) * rain.speedOf(drop.diameter);
    }
  }
  return 3600.0 * 1000.0 * flow / kCells;
}

TEST(Rain, HasAsMuchWaterAsFalls) {
  // Marshall and Palmer's sizes are a fit and do not come from the same measurement as the speeds.
  for (const double rate : {2.0, 10.0, 50.0}) {
    EXPECT_NEAR(hourOf(Precipitation::rain(rate)) / rate, 1.0, 0.25) << rate;
  }
}

TEST(Rain, FallsAsFastAsWasMeasured) {
  // Gunn and Kinzer (1949) at 20 degrees: 1 mm 4.03, 3 mm 8.06 m/s.
  const Precipitation rain = Precipitation::rain(10.0);
  EXPECT_NEAR(rain.speedOf(0.001), 4.03, 0.1);
  EXPECT_NEAR(rain.speedOf(0.003), 8.06, 0.15);
}

TEST(Snow, FallsSlowlyAndHasGaps) {
  const Precipitation snow = Precipitation::snow(1.0);
  EXPECT_NEAR(snow.speedOf(0.005), 1.0, 0.1);
  EXPECT_GT(snow.opacityOf(0.005), 0.2);
  EXPECT_LT(snow.opacityOf(0.005), 0.5);
  EXPECT_EQ(Precipitation::rain(1.0).opacityOf(0.005), 1.0);
}

TEST(Precipitation, HasTheSameDropsForWhoeverLooks) {
  const Precipitation snow = Precipitation::snow(1.0);
  const std::vector<Drop> large = snow.in({1, 2, 3}, 0.004, 9);
  const std::vector<Drop> all = snow.in({1, 2, 3}, 0.0005, 9);
  ASSERT_GT(large.size(), 5U);
  ASSERT_GT(all.size(), 3 * large.size());
  for (std::size_t i = 0; i < large.size(); ++i) {
    EXPECT_EQ(large[i].p_G, all[i].p_G);
    EXPECT_EQ(large[i].diameter, all[i].diameter);
    EXPECT_GE(large[i].diameter, 0.004);
  }
  EXPECT_NE(snow.in({1, 2, 4}, 0.004, 9).front().p_G, large.front().p_G);
  EXPECT_NE(snow.in({1, 2, 3}, 0.004, 8).front().p_G, large.front().p_G);
}

TEST(Precipitation, IsWithinItsCell) {
  for (const Drop& drop : Precipitation::rain(20.0).in({-4, 0, 7}, 0.0005, 1)) {
    EXPECT_TRUE(((drop.p_G - Eigen::Vector3d(-4, 0, 7)).array() >= 0.0).all());
    EXPECT_TRUE(((drop.p_G - Eigen::Vector3d(-4, 0, 7)).array() <= 1.0).all());
  }
}

}  // namespace precipitation_test
}  // namespace synthetic_dataset::render
