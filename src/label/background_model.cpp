#include "label/background_model.h"

#include "label/mask.h"

namespace synthetic_dataset::label {

cv::Mat BackgroundModel::segment(const cv::Mat& alone, const cv::Rect& box) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (picture_) segmenter_.train(std::exchange(picture_, {})());
  const cv::Mat raw = segmenter_.segment(alone, box);
  if (!clean_) return raw;
  // What is around the box distinguishes holes from bays.
  constexpr int kRound = label::kLargestHole + 1;
  const cv::Rect bounds =
      cv::Rect(box.x - kRound, box.y - kRound, box.width + 2 * kRound, box.height + 2 * kRound) &
      cv::Rect(cv::Point(), alone.size());
  cv::Mat framed = cv::Mat::zeros(bounds.size(), CV_8UC1);
  raw.copyTo(framed(box - bounds.tl()));
  return label::cleanMask(framed)(box - bounds.tl());
}

}  // namespace synthetic_dataset::label
