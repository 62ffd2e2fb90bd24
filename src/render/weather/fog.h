#pragma once

#include <opencv2/core/mat.hpp>

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

}  // namespace synthetic_dataset::render
