#pragma once

#include <algorithm>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset {

/// Makes a picture by applying a function to each pixel of another.
/// @param function  from a pixel of `picture` to a pixel of the result
template <class To, class From, class Function>
[[nodiscard]] cv::Mat_<To> mapped(const cv::Mat_<From>& picture, Function function) {
  cv::Mat_<To> result(picture.size());
  for (int row = 0; row < picture.rows; ++row) {
    std::transform(picture[row], picture[row] + picture.cols, result[row], function);
  }
  return result;
}

}  // namespace synthetic_dataset
