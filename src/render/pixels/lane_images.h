#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <opencv2/core.hpp>

#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {

/// An image with at least kLaneCount columns: the last column of a narrower one is repeated.
[[nodiscard]] inline cv::Mat widened(const cv::Mat& image) {
  if (image.empty() || image.cols >= kLaneCount) return image;
  cv::Mat wide;
  cv::copyMakeBorder(image, wide, 0, 0, 0, kLaneCount - image.cols, cv::BORDER_REPLICATE);
  return wide;
}

/// Returns a pointer to at least `count` values of a row, padded with zeros if too few are left.
/// @param room  for the padded values; has to outlive the result
template <std::size_t count, class Value>
[[nodiscard]] const Value* atLeast(const Value* values, int left, std::array<Value, count>& room) {
  if (left >= static_cast<int>(count)) return values;
  room = {};
  std::copy_n(values, left, room.begin());
  return room.data();
}

/// The first column of four pixels to process: `column`, or less so that they do not extend beyond
/// the row's end, and some are processed twice instead.
[[nodiscard]] inline int firstLane(int column, int columns) {
  return std::min(column, columns - kLaneCount);
}

}  // namespace synthetic_dataset::render
