#include "render/weather/fog.h"

#include <algorithm>
#include <cmath>

namespace synthetic_dataset::render {
namespace {

/// [1/m] of an attenuation in dB/km.
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
  constexpr float kDepth = 1000.0F;  // [m] of the fog before the background
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

}  // namespace synthetic_dataset::render
