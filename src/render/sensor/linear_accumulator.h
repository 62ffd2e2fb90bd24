#pragma once

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// Averages pictures in linear light, as a sensor does while its shutter is open.
class LinearAccumulator {
 public:
  /// Adds a picture.
  /// @param pixels  CV_8UC3, sRGB-encoded, all of one size; must not be written to while this
  ///   accumulator exists
  /// @param weight  the weights of all pictures should add up to 1
  void add(const cv::Mat& pixels, double weight);

  /// The mean of one picture or more: CV_8UC3, sRGB-encoded.
  [[nodiscard]] cv::Mat result() const;

 private:
  cv::Mat first_;    ///< the first picture
  cv::Mat further_;  ///< CV_32FC3: the weighted light of the others minus that of the first
  cv::Mat differs_;  ///< CV_8UC1, per block of each row: not 0 where others differ from the first
};

}  // namespace synthetic_dataset::render
