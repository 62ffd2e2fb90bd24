#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "render/weather/through_weather.h"

namespace synthetic_dataset::render {
namespace fog_test {

constexpr float kBackground = std::numeric_limits<float>::infinity();

TEST(AirFog, LeavesATwentiethOfTheLightOverItsVisibility) {
  Weather weather;
  weather.visibility = 80.0;
  const cv::Mat distances = (cv::Mat_<float>(1, 4) << 80.0F, 160.0F, 0.0F, kBackground);
  const cv::Mat passing = passingLight(distances, extinction(weather));
  EXPECT_NEAR(passing.at<float>(0), 0.05, 1e-5);
  EXPECT_NEAR(passing.at<float>(1), 0.0025, 1e-6);
  EXPECT_EQ(passing.at<float>(2), 1.0F);  // where a lens sees nothing
  EXPECT_LT(passing.at<float>(3), 1e-6);
}

TEST(AirFog, ThatIsThinLeavesTheBackground) {
  Weather weather;
  weather.visibility = 20000.0;
  const cv::Mat distances(1, 1, CV_32FC1, cv::Scalar(kBackground));
  EXPECT_NEAR(passingLight(distances, extinction(weather)).at<float>(0), 0.86, 0.01);
}

TEST(AirFog, IsMadeByRainAndSnowToo) {
  // ITU-R P.1814: 1.076 x 25^0.67 = 9.30 dB/km, and 5.526 x 2^1.38 = 14.4 dB/km.
  Weather weather;
  weather.rain = 25.0;
  EXPECT_NEAR(10.0 * std::log10(std::exp(1000.0 * extinction(weather))), 9.30, 0.01);
  weather = {};
  weather.snow = 2.0;
  EXPECT_NEAR(10.0 * std::log10(std::exp(1000.0 * extinction(weather))), 14.4, 0.05);
  EXPECT_EQ(extinction({}), 0.0);
}

}  // namespace fog_test
}  // namespace synthetic_dataset::render
