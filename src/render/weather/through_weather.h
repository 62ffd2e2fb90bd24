#pragma once

#include <cstdint>

#include <opencv2/core/mat.hpp>

#include "render/view.h"
#include "render/weather/weather.h"

namespace synthetic_dataset::render {

/// Which share of the light the air takes on a short way, divided by that way [1/m]: fog (3 over
/// the visibility), rain and dry snow (Recommendation ITU-R P.1814, for light of 550 nm).
[[nodiscard]] double extinction(const Weather& weather);

/// Which share of the light of what is seen arrives through the air (Beer and Lambert). Where
/// nothing is seen but the background, the fog counts as 1 km deep: in thick fog it is hidden, haze
/// leaves it.
/// @param distances  CV_32FC1: as of Renderer::distances
/// @return CV_32FC1 of the same size, 0 .. 1; 1 where a lens sees nothing
[[nodiscard]] cv::Mat passingLight(const cv::Mat& distances, double extinction);

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
