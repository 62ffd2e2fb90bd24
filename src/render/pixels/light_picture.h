#pragma once

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// What a picture's numbers mean.
enum class PixelMeaning {
  kColour,  ///< sRGB-encoded; decoded when it is read
  kData,    ///< read as they are: directions, roughness
};

/// Converts a picture to numbers that may be averaged: colours to linear light; alpha and data stay
/// as they are.
/// @param picture  CV_8UC4: blue, green, red, alpha; or CV_32FC4, which is linear light already
/// @return CV_16UC4, 65535 for 1; or CV_32FC4, 1 for 1
[[nodiscard]] cv::Mat toLight(const cv::Mat& picture, PixelMeaning meaning);

/// The inverse of toLight(), rounded to the nearest values.
/// @param light  as returned by toLight()
[[nodiscard]] cv::Mat fromLight(const cv::Mat& light, PixelMeaning meaning);

}  // namespace synthetic_dataset::render
