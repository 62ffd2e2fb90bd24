#pragma once

#include <map>
#include <mutex>
#include <utility>

#include <opencv2/core/mat.hpp>
#include <opencv2/video/background_segm.hpp>

#include "label/label_options.h"
#include "render/pending_picture.h"

namespace synthetic_dataset::label {

/// Finds an object by what has changed in the picture: how the paper obtains masks.
///
/// Zivkovic, "Improved adaptive Gaussian mixture model for background subtraction" (ICPR 2004), in
/// OpenCV's implementation, cv::BackgroundSubtractorMOG2. Each pixel is judged independently, so
/// only the tiles of a picture that are needed are learned.
class Mog2Segmenter {
 public:
  explicit Mog2Segmenter(const Mog2Options& options) : options_(options) {}

  /// Learns the picture without objects from scratch: it is shown history_length times, with
  /// OpenCV's default learning rate. Our pictures have no noise, so all of them would be equal
  /// anyway.
  /// @param background  CV_8UC3
  void train(const cv::Mat& background);

  /// The pixels that differ from the background: 255 foreground, 127 shadow, 0 background. The
  /// model does not learn from the picture (learning rate 0).
  /// @param image  of the background's size
  /// @param region  the pixels to judge, within the image
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

/// The model of the picture without objects that masks are found with; learned when it is first
/// needed. May be used from several threads at once.
class BackgroundModel {
 public:
  /// @param clean  fill holes and remove specks
  BackgroundModel(render::PendingPicture picture, const label::Mog2Options& options, bool clean)
      : picture_(std::move(picture)), segmenter_(options), clean_(clean) {}

  /// The pixels that differ from the background.
  /// @param alone  a picture with an object in a box, and no other object in that box
  /// @return CV_8UC1 of the box's size: 255 or 0
  [[nodiscard]] cv::Mat segment(const cv::Mat& alone, const cv::Rect& box);

 private:
  std::mutex mutex_;                ///< guards all members
  render::PendingPicture picture_;  ///< empty once it has been learned
  label::Mog2Segmenter segmenter_;
  bool clean_;
};

}  // namespace synthetic_dataset::label
