#pragma once

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// What a picture's numbers are.
enum class PixelMeaning {
  kColour,  ///< sRGB-encoded; decoded when it is read
  kData,    ///< read as they are: directions, roughness
};

/// Numbers of which means may be taken: of colours their linear light; alpha and data as they are.
/// @param picture  CV_8UC4: blue, green, red, alpha; or CV_32FC4, which are light
/// @return CV_16UC4, 65535 for 1; or CV_32FC4, 1 for 1
[[nodiscard]] cv::Mat toLight(const cv::Mat& picture, PixelMeaning meaning);

/// The picture whose pixels have them, to the nearest.
/// @param light  of toLight()
[[nodiscard]] cv::Mat fromLight(const cv::Mat& light, PixelMeaning meaning);

}  // namespace synthetic_dataset::render
