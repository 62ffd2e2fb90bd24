#include "render/weather/through_weather.h"

#include "render/pixels/srgb.h"
#include "render/weather/drop_painter.h"
#include "render/weather/fog.h"
#include "render/weather/precipitation.h"

namespace synthetic_dataset::render {

cv::Mat throughWeather(const cv::Mat& picture, const TakenView& taken, const Weather& weather,
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
