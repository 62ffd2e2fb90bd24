#pragma once

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// Averages pictures as light adds up: what a sensor gathers while its shutter is open.
class LinearAccumulator {
 public:
  /// Adds a picture.
  /// @param pixels  CV_8UC3, sRGB-encoded, all of one size; not to be written to as long as this
  /// lives
  /// @param weight  all of them should add up to 1
  void add(const cv::Mat& pixels, double weight);

  /// The mean of one picture or more: CV_8UC3, sRGB-encoded.
  [[nodiscard]] cv::Mat result() const;

 private:
  cv::Mat first_;    ///< of the pictures
  cv::Mat further_;  ///< CV_32FC3: how much more light the others brought than the first would have
  cv::Mat differs_;  ///< CV_8UC1, for blocks of each row: not 0 where others differ from it
};

}  // namespace synthetic_dataset::render
