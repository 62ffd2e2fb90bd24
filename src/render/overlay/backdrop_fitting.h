#pragma once

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// The largest part in the middle of a picture that has an image's proportions, to a pixel.
[[nodiscard]] cv::Rect partFilling(const cv::Size& picture, const cv::Size& image);

/// A picture of another size: means of light where it gets smaller; the pixels as they are where it
/// has that size.
/// @param picture  CV_8UC4, sRGB-encoded, or CV_32FC4, linear light; opaque
[[nodiscard]] cv::Mat scaledTo(const cv::Size& size, const cv::Mat& picture);

}  // namespace synthetic_dataset::render
