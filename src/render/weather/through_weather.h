#pragma once

#include <cstdint>

#include <opencv2/core/mat.hpp>

#include "render/view.h"
#include "render/weather/weather.h"

namespace synthetic_dataset::render {

/// How a picture was taken.
struct TakenView {
  View view;
  cv::Mat distances;    ///< as of Renderer::distances
  double gain = 1.0;    ///< on all light
  double exposure = 0;  ///< for how long the shutter is open [s]
};

/// A picture as it looks through the weather.
/// @param picture  CV_8UC3, sRGB-encoded
/// @param seed  of the drops; views of one instant should have the same
[[nodiscard]] cv::Mat throughWeather(const cv::Mat& picture, const TakenView& taken,
                                     const Weather& weather, std::uint64_t seed);

}  // namespace synthetic_dataset::render
