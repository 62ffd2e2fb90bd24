#pragma once

#include <algorithm>

#include <opencv2/core.hpp>

#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {

/// An image with columns enough for all lanes: a narrow one's last column goes on.
[[nodiscard]] inline cv::Mat widened(const cv::Mat& image) {
  if (image.empty() || image.cols >= kLaneCount) return image;
  cv::Mat wide;
  cv::copyMakeBorder(image, wide, 0, 0, 0, kLaneCount - image.cols, cv::BORDER_REPLICATE);
  return wide;
}

/// Where the four pixels begin that hold a column of a row: the last ones of a row twice, rather
/// than some beyond its end.
[[nodiscard]] inline int firstLane(int column, int columns) {
  return std::min(column, columns - kLaneCount);
}

}  // namespace synthetic_dataset::render
