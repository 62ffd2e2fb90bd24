#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <opencv2/core/mat.hpp>

#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {

/// A row of a map, in which the values at the map's edges are repeated beyond them.
class MapRow {
 public:
  /// @param map  CV_32FC1; has to outlive this object
  MapRow(const cv::Mat& map, int row)
      : numbers_(map.ptr<float>(std::clamp(row, 0, map.rows - 1))), count_(map.cols) {}

  /// Four numbers, beginning at a column.
  [[nodiscard]] Lanes four(int column) const {
    if (column >= 0 && column + kLaneCount <= count_) return cv::v_load(numbers_ + column);
    std::array<float, kLaneCount> some{};
    for (int i = 0; i < kLaneCount; ++i) {
      some[static_cast<std::size_t>(i)] = numbers_[std::clamp(column + i, 0, count_ - 1)];
    }
    return cv::v_load(some.data());
  }

 private:
  const float* numbers_;
  int count_;
};

}  // namespace synthetic_dataset::render
