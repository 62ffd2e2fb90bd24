#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// Rectangles, none of them over another, that hold all pixels that are not 0, and few others.
/// @param pixels  CV_8UC1
[[nodiscard]] std::vector<cv::Rect> bandsOf(const cv::Mat& pixels);

/// Round all of them; empty for none.
[[nodiscard]] cv::Rect boundsOf(const std::vector<cv::Rect>& rectangles);

}  // namespace synthetic_dataset::render
