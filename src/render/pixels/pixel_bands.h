#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// Height of bands that are processed pixel by pixel [px]. Finer bands waste fewer pixels, but take
/// their time each.
inline constexpr int kFineBand = 8;

/// Height of bands whose set-up takes longer than their work [px].
inline constexpr int kCoarseBand = 64;

/// Rectangles, none of them over another, that hold all pixels that are not 0, and few others.
/// @param pixels  CV_8UC1
/// @param height  of a rectangle at the most [px]
[[nodiscard]] std::vector<cv::Rect> bandsOf(const cv::Mat& pixels, int height = kFineBand);

/// Pixels that are not 0, and those around them.
/// @param pixels  CV_8UC1
/// @param distance  how far in columns and rows
[[nodiscard]] cv::Mat withPixelsAround(const cv::Mat& pixels, int distance = 1);

/// With this many more pixels on each side.
[[nodiscard]] cv::Rect grown(const cv::Rect& rectangle, int distance);

/// Around all of them; empty for none.
[[nodiscard]] cv::Rect boundsOf(const std::vector<cv::Rect>& rectangles);

}  // namespace synthetic_dataset::render
