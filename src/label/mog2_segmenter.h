#pragma once

#include <map>
#include <utility>

#include <opencv2/core/mat.hpp>
#include <opencv2/video/background_segm.hpp>

#include "label/mog2_options.h"

namespace synthetic_dataset::label {

/// Finds an object by what changed in the picture: the paper's way to masks.
///
/// Zivkovic, "Improved adaptive Gaussian mixture model for background subtraction" (ICPR 2004), as
/// OpenCV has it: cv::BackgroundSubtractorMOG2. Each pixel is judged by itself, so only the tiles
/// of a picture that are looked at are learned.
class Mog2Segmenter {
 public:
  explicit Mog2Segmenter(const Mog2Options& options) : options_(options) {}

  /// Learns the picture without objects anew: it is shown history_length times, with OpenCV's
  /// default learning rate. Our pictures have no noise, so they would all be equal.
  /// @param background  CV_8UC3
  void train(const cv::Mat& background);

  /// The pixels that differ from the background: 255 foreground, 127 shadow, 0 background. The
  /// model does not learn from the picture (learning rate 0).
  /// @param image  of the background's size
  /// @param region  the pixels that are looked at, within the image
  /// @return CV_8UC1 of the region's size
  /// @throws Error before the first train()
  [[nodiscard]] cv::Mat segment(const cv::Mat& image, const cv::Rect& region);

 private:
  using Subtractor = cv::Ptr<cv::BackgroundSubtractorMOG2>;

  [[nodiscard]] Subtractor learned(const cv::Rect& tile) const;

  Mog2Options options_;
  cv::Mat background_;
  std::map<std::pair<int, int>, Subtractor> tiles_;  ///< by row and column
};

}  // namespace synthetic_dataset::label
