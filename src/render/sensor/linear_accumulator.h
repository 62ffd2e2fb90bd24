#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

namespace synthetic_dataset::render {

/// Averages pictures as light adds up: what a sensor gathers while its shutter is open.
class LinearAccumulator {
 public:
  /// @param size  of the picture [px]; it begins dark
  explicit LinearAccumulator(const cv::Size& size);

  /// Adds a part of a picture.
  /// @param pixels  CV_8UC3 of the region's size, sRGB-encoded
  /// @param weight  those of a pixel should add up to 1
  void add(const cv::Mat& pixels, const cv::Rect& region, double weight);

  /// The sum so far: CV_8UC3, sRGB-encoded.
  [[nodiscard]] cv::Mat result() const;

  /// Makes it dark again.
  void clear();

 private:
  cv::Mat light_;  ///< CV_32FC3
};

}  // namespace synthetic_dataset::render
