#include "label/mog2_segmenter.h"

#include "label/mask.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::label {

void Mog2Segmenter::train(const cv::Mat& background) {
  background_ = background.clone();
  tiles_.clear();
}

cv::Mat Mog2Segmenter::segment(const cv::Mat& image, const cv::Rect& region) {
  if (background_.empty()) throw Error("the background subtractor was used before it was trained");
  constexpr int kTile = 64;  // [px]; smaller ones waste fewer pixels, but each takes a call
  constexpr double kLearnNothing = 0.0;
  const cv::Rect whole(cv::Point(), background_.size());
  cv::Mat mask = cv::Mat::zeros(region.size(), CV_8UC1);
  cv::Mat of_tile;
  for (int row = region.y / kTile; row * kTile < region.y + region.height; ++row) {
    for (int column = region.x / kTile; column * kTile < region.x + region.width; ++column) {
      const cv::Rect tile = cv::Rect(column * kTile, row * kTile, kTile, kTile) & whole;
      Subtractor& subtractor = tiles_[{row, column}];
      if (!subtractor) subtractor = learned(tile);
      subtractor->apply(image(tile), of_tile, kLearnNothing);
      const cv::Rect seen = tile & region;
      of_tile(seen - tile.tl()).copyTo(mask(seen - region.tl()));
    }
  }
  return mask;
}

Mog2Segmenter::Subtractor Mog2Segmenter::learned(const cv::Rect& tile) const {
  Subtractor subtractor = cv::createBackgroundSubtractorMOG2(
      options_.history_length, options_.var_threshold, options_.detect_shadows);
  cv::Mat ignored;
  for (int i = 0; i < options_.history_length; ++i) subtractor->apply(background_(tile), ignored);
  return subtractor;
}

cv::Mat BackgroundModel::segment(const cv::Mat& alone, const cv::Rect& box) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (picture_) segmenter_.train(std::exchange(picture_, {})());
  cv::Mat raw = segmenter_.segment(alone, box);
  if (!clean_) return raw;
  // The pixels around the box distinguish holes from bays.
  constexpr int kRound = label::kLargestHole + 1;
  const cv::Rect bounds =
      cv::Rect(box.x - kRound, box.y - kRound, box.width + 2 * kRound, box.height + 2 * kRound) &
      cv::Rect(cv::Point(), alone.size());
  cv::Mat framed = cv::Mat::zeros(bounds.size(), CV_8UC1);
  raw.copyTo(framed(box - bounds.tl()));
  return label::cleanMask(framed)(box - bounds.tl());
}

}  // namespace synthetic_dataset::label
