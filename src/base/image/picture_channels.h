#pragma once

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::base {

// Pictures are CV_8UC4: blue, green, red, alpha. Functions return a new picture.

/// Whether alpha is 255 all over.
[[nodiscard]] bool isOpaque(const cv::Mat& picture);

/// @return the picture itself if it is already opaque
[[nodiscard]] cv::Mat withoutAlpha(const cv::Mat& picture);

/// Whether red, green and blue are the same all over.
[[nodiscard]] bool isGrey(const cv::Mat& picture);

/// The red channel in all three channels, opaque.
[[nodiscard]] cv::Mat redAsGrey(const cv::Mat& picture);

/// 255 minus the red channel in all three channels, opaque.
[[nodiscard]] cv::Mat invertedRedAsGrey(const cv::Mat& picture);

/// White, with the picture's grey value as alpha, or with its own alpha if it is not opaque.
[[nodiscard]] cv::Mat greyAsAlpha(const cv::Mat& picture);

/// The picture with the alpha of another one, which is resized to fit.
[[nodiscard]] cv::Mat withAlphaOf(const cv::Mat& picture, const cv::Mat& alpha);

/// The normal map (x right, y up the picture, z towards the viewer; 0 .. 255 for -1 .. 1) of a
/// height map given as grey values; the picture wraps around at its edges.
[[nodiscard]] cv::Mat normalsOfHeights(const cv::Mat& picture);

}  // namespace synthetic_dataset::base
