#include "render/weather/through_weather.h"

#include <algorithm>
#include <cmath>

#include "render/pixels/srgb.h"
#include "render/weather/drop_painter.h"
#include "render/weather/precipitation.h"

namespace synthetic_dataset::render {
namespace {

/// Converts an attenuation from dB/km to 1/m.
double perMetre(double decibels) { return decibels * std::log(10.0) / 10.0 / 1000.0; }

}  // namespace

double extinction(const Weather& weather) {
  const double fog = -std::log(0.05) / weather.visibility;
  const double rain = weather.rain > 0.0 ? perMetre(1.076 * std::pow(weather.rain, 0.67)) : 0.0;
  constexpr double kWavelength = 550.0;  // [nm]
  const double snow =
      weather.snow > 0.0
          ? perMetre((5.42e-5 * kWavelength + 5.4958776) * std::pow(weather.snow, 1.38))
          : 0.0;
  return fog + rain + snow;
}

cv::Mat passingLight(const cv::Mat& distances, double extinction) {
  constexpr float kDepth = 1000.0F;  // [m] of the fog in front of the background
  const auto each_metre = static_cast<float>(-extinction);
  cv::Mat passing(distances.size(), CV_32FC1);
  for (int v = 0; v < distances.rows; ++v) {
    const auto* from = distances.ptr<float>(v);
    std::transform(from, from + distances.cols, passing.ptr<float>(v), [&](float distance) {
      return std::exp(each_metre * (std::isinf(distance) ? kDepth : distance));
    });
  }
  return passing;
}

cv::Mat throughWeather(const cv::Mat& picture, const CapturedView& taken, const Weather& weather,
                       std::uint64_t seed) {
  cv::Mat passing = passingLight(taken.distances, extinction(weather));
  const auto draw = [&](const Precipitation& falling) {
    drawDrops(falling, weather.wind_G, taken.exposure, taken.view, seed, taken.distances, passing);
  };
  if (weather.rain > 0.0) draw(Precipitation::rain(weather.rain));
  if (weather.snow > 0.0) draw(Precipitation::snow(weather.snow));
  const Eigen::Vector3f air = static_cast<float>(taken.gain) * linearFromSrgb(weather.colour);
  const auto& linear = linearFromSrgb();
  cv::Mat result(picture.size(), CV_8UC3);
  for (int v = 0; v < picture.rows; ++v) {
    for (int u = 0; u < picture.cols; ++u) {
      const float share = passing.at<float>(v, u);
      const auto& from = picture.at<cv::Vec3b>(v, u);
      auto& to = result.at<cv::Vec3b>(v, u);
      for (int channel = 0; channel < 3; ++channel) {
        to[channel] =
            srgbFromLinear(share * linear[from[channel]] + (1.0F - share) * air[2 - channel]);
      }
    }
  }
  return result;
}

}  // namespace synthetic_dataset::render
