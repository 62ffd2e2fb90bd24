#pragma once

#include <cstdint>

#include <opencv2/core/mat.hpp>

#include "render/view.h"
#include "render/weather/weather.h"

namespace synthetic_dataset::render {

/// The extinction coefficient of the air [1/m]: of fog (3 over the visibility), rain and dry snow
/// (Recommendation ITU-R P.1814, for light of 550 nm).
[[nodiscard]] double extinction(const Weather& weather);

/// The share of light that arrives through the air from what is seen (Beer and Lambert). In front
/// of the background, the fog is taken to be 1 km deep: thick fog hides the background, haze does
/// not.
/// @param distances  CV_32FC1: as from Renderer::distances()
/// @return CV_32FC1 of the same size, 0 .. 1; 1 where a lens sees nothing
[[nodiscard]] cv::Mat passingLight(const cv::Mat& distances, double extinction);

/// How a picture was taken.
struct CapturedView {
  View view;
  cv::Mat distances;    ///< as from Renderer::distances()
  double gain = 1.0;    ///< on all light
  double exposure = 0;  ///< for how long the shutter is open [s]
};

/// A picture as seen through the weather.
/// @param picture  CV_8UC3, sRGB-encoded
/// @param seed  of the drops; views of one instant should have the same
[[nodiscard]] cv::Mat throughWeather(const cv::Mat& picture, const CapturedView& taken,
                                     const Weather& weather, std::uint64_t seed);

}  // namespace synthetic_dataset::render
