#pragma once

#include <algorithm>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset {

/// A picture whose pixels are made of another's, one by one.
/// @param function  from a pixel of the one to a pixel of the other
template <class To, class From, class Function>
[[nodiscard]] cv::Mat_<To> mapped(const cv::Mat_<From>& picture, Function function) {
  cv::Mat_<To> result(picture.size());
  for (int row = 0; row < picture.rows; ++row) {
    std::transform(picture[row], picture[row] + picture.cols, result[row], function);
  }
  return result;
}

}  // namespace synthetic_dataset
