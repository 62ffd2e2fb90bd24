#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// Gazebo Classic finds light in the encoded numbers of its picture (sRGB's, though it knows
/// nothing of that). Here such pictures are made linear again, so that all that follows is the same
/// for both simulators. An encoded number above 1 is one that a short exposure still shows.

/// The largest encoded number that makes a difference in a picture: 1, as it is in Gazebo's, or
/// what a shorter exposure than 1 brings down to white, up to 16.
[[nodiscard]] float brightestEncoded(float exposure);

/// Turns encoded numbers into exposed linear light, 1 at most.
/// @param light  CV_16UC4: red, green, blue and something else, numbers of 16 bits (IEEE 754
///     binary16); that stays
/// @param regions  of it, beside which it stays as it is
void exposeEncoded(cv::Mat& light, float exposure, const std::vector<cv::Rect>& regions);

}  // namespace synthetic_dataset::render
