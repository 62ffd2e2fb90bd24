#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// Gazebo Classic computes light directly in the encoded numbers of its picture (which are sRGB,
/// although it is not aware of that). These functions make such pictures linear, so that everything
/// that follows is the same for both simulators. Encoded numbers above 1 are kept for exposures
/// that are short enough to show them.

/// The largest encoded number that makes a difference in a picture: 1, as in Gazebo, or, with an
/// exposure below 1, the number that becomes white, up to 16.
[[nodiscard]] float brightestEncoded(float exposure);

/// Turns encoded numbers into exposed linear light, 1 at most.
/// @param light  CV_16UC4: red, green, blue and a fourth value, which is not changed, as half
///     floats (IEEE 754 binary16)
/// @param regions  of `light`, outside which it is not changed
void exposeEncoded(cv::Mat& light, float exposure, const std::vector<cv::Rect>& regions);

}  // namespace synthetic_dataset::render
