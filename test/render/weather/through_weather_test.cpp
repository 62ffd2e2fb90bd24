#include "render/weather/through_weather.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace synthetic_dataset::render {
namespace through_weather_test {

CapturedView takenOf(float distance) {
  return {{CameraModel(64, 48, {60, 60, 31.5, 23.5}, 0.1, 100.0), Pose::Identity()},
          cv::Mat(48, 64, CV_32FC1, cv::Scalar(distance)),
          1.0,
          0.005};
}

const cv::Mat kRed(48, 64, CV_8UC3, cv::Scalar(0, 0, 200));

TEST(ThroughWeather, FogMixesLightAndNotNumbers) {
  Weather weather;
  weather.visibility = 10.0;
  weather.colour = {1.0F, 1.0F, 1.0F};
  // At this distance half of the light passes: of white 0.5, encoded 188; of red 0.578 x 0.5 + 0.5.
  const auto half = static_cast<float>(10.0 * std::log(0.5) / std::log(0.05));
  const cv::Mat seen = throughWeather(kRed, takenOf(half), weather, 0);
  EXPECT_EQ(seen.at<cv::Vec3b>(20, 30), cv::Vec3b(188, 188, 230));
}

TEST(ThroughWeather, AnOverexposedPictureHasBrighterFog) {
  Weather weather;
  weather.visibility = 10.0;
  weather.colour = {0.0F, 0.5F, 0.0F};
  CapturedView taken = takenOf(std::numeric_limits<float>::infinity());
  taken.gain = 2.0;
  const cv::Vec3b seen = throughWeather(kRed, taken, weather, 0).at<cv::Vec3b>(20, 30);
  EXPECT_EQ(seen, cv::Vec3b(0, 175, 0));  // of twice the light of 0.5 (128)
}

TEST(ThroughWeather, RainAndSnowAreBothSeen) {
  Weather weather;
  weather.colour = {1.0F, 1.0F, 1.0F};
  weather.snow = 1.0;
  const cv::Mat snow = throughWeather(kRed, takenOf(20.0F), weather, 3);
  weather.rain = 100.0;
  const cv::Mat both = throughWeather(kRed, takenOf(20.0F), weather, 3);
  EXPECT_GT(cv::norm(snow, kRed, cv::NORM_INF), 30.0);
  EXPECT_GT(cv::norm(both, snow, cv::NORM_INF), 3.0);
}

TEST(ThroughWeather, IsBlackWhereALensSeesNothing) {
  Weather weather;
  weather.visibility = 5.0;
  weather.snow = 3.0;
  const cv::Mat black(48, 64, CV_8UC3, cv::Scalar::all(0));
  EXPECT_EQ(cv::norm(throughWeather(black, takenOf(0.0F), weather, 1), cv::NORM_INF), 0.0);
}

}  // namespace through_weather_test
}  // namespace synthetic_dataset::render
