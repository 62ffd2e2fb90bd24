#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// Height of bands that are processed pixel by pixel [px]. Finer bands waste fewer pixels, but each
/// has a cost of its own.
inline constexpr int kFineBand = 8;

/// Height of bands whose set-up takes longer than their processing [px].
inline constexpr int kCoarseBand = 64;

/// Rectangles that do not overlap and contain all pixels that are not 0, and few others.
/// @param pixels  CV_8UC1
/// @param height  the maximum height of a rectangle [px]
[[nodiscard]] std::vector<cv::Rect> bandsOf(const cv::Mat& pixels, int height = kFineBand);

/// A mask of the pixels that are not 0 and of those around them.
/// @param pixels  CV_8UC1
/// @param distance  up to how many columns and rows away
[[nodiscard]] cv::Mat withPixelsAround(const cv::Mat& pixels, int distance = 1);

/// The rectangle, grown by this many pixels on each side.
[[nodiscard]] cv::Rect grown(const cv::Rect& rectangle, int distance);

/// The rectangle around all of them; empty if there are none.
[[nodiscard]] cv::Rect boundsOf(const std::vector<cv::Rect>& rectangles);

}  // namespace synthetic_dataset::render
