#pragma once

#include <map>
#include <mutex>
#include <utility>

#include <opencv2/core/mat.hpp>
#include <opencv2/video/background_segm.hpp>

#include "label/label_options.h"
#include "render/pending_picture.h"

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

/// The picture without objects that masks are found with; learned when it is first needed. May be
/// used in any thread, by several at once.
class BackgroundModel {
 public:
  /// @param clean  fill holes and remove specks
  BackgroundModel(render::PendingPicture picture, const label::Mog2Options& options, bool clean)
      : picture_(std::move(picture)), segmenter_(options), clean_(clean) {}

  /// What differs from the background.
  /// @param alone  a picture with an object in a box, and nothing else that disturbs there
  /// @return CV_8UC1 of the box's size: 255 or 0
  [[nodiscard]] cv::Mat segment(const cv::Mat& alone, const cv::Rect& box);

 private:
  std::mutex mutex_;                ///< of all
  render::PendingPicture picture_;  ///< none once it is learned
  label::Mog2Segmenter segmenter_;
  bool clean_;
};

}  // namespace synthetic_dataset::label
