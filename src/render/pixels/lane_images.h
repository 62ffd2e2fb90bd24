#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

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

/// At least this many values of a row, with zeros behind the last one if too few are left.
/// @param room  for them; has to outlive the result
template <std::size_t count, class Value>
[[nodiscard]] const Value* atLeast(const Value* values, int left, std::array<Value, count>& room) {
  if (left >= static_cast<int>(count)) return values;
  room = {};
  std::copy_n(values, left, room.begin());
  return room.data();
}

/// Where the four pixels begin that hold a column of a row: the last ones of a row twice, rather
/// than some beyond its end.
[[nodiscard]] inline int firstLane(int column, int columns) {
  return std::min(column, columns - kLaneCount);
}

}  // namespace synthetic_dataset::render
