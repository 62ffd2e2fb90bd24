#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// Linear light from sRGB-encoded red, green and blue.
[[nodiscard]] Eigen::Vector3f linearFromSrgb(const Eigen::Vector3f& encoded);

/// Alpha, the last, is linear in either.
[[nodiscard]] Eigen::Vector4f linearFromSrgb(const Eigen::Vector4f& encoded);

/// A picture of linear light, encoded; what is brighter than 1 is white, what is negative black.
/// @param light  CV_16UC4: red, green, blue, alpha as numbers of 16 bits (IEEE 754 binary16)
/// @return CV_8UC3: blue, green and red
[[nodiscard]] cv::Mat srgbFromLinear(const cv::Mat& light);

}  // namespace synthetic_dataset::render
