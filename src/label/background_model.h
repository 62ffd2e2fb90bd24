#pragma once

#include <mutex>
#include <utility>

#include "label/mog2_segmenter.h"
#include "render/pending_picture.h"

namespace synthetic_dataset::label {

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
