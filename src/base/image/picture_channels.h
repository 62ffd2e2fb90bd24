#pragma once

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::base {

// Pictures are CV_8UC4: blue, green, red, alpha. Each function gives a new one.

/// Whether alpha is 255 all over.
[[nodiscard]] bool isOpaque(const cv::Mat& picture);

/// @return the picture itself where it is opaque already
[[nodiscard]] cv::Mat withoutAlpha(const cv::Mat& picture);

/// Whether red, green and blue are the same all over.
[[nodiscard]] bool isGrey(const cv::Mat& picture);

/// Its red channel in place of all three, opaque.
[[nodiscard]] cv::Mat redAsGrey(const cv::Mat& picture);

/// 255 minus its red channel in place of all three, opaque.
[[nodiscard]] cv::Mat invertedRedAsGrey(const cv::Mat& picture);

/// White, with the other's grey value as alpha; its alpha where it is not opaque.
[[nodiscard]] cv::Mat greyAsAlpha(const cv::Mat& picture);

/// The picture with the alpha of another one, which is brought to its size.
[[nodiscard]] cv::Mat withAlphaOf(const cv::Mat& picture, const cv::Mat& alpha);

/// A normal map (x right, y up the picture, z towards the viewer; 0 .. 255 for -1 .. 1) of grey
/// values that are heights; the picture goes on at the opposite edge.
[[nodiscard]] cv::Mat normalsOfHeights(const cv::Mat& picture);

}  // namespace synthetic_dataset::base
