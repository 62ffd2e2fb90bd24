#include "render/shadows/map_depths.h"

#include <opencv2/core.hpp>

namespace synthetic_dataset::render {

MapDepths::Assembled MapDepths::assemble() const {
  Assembled result;
  if (pieces_.empty()) {
    result.depths_ = standing_->depths_;
    return result;
  }
  result.lock_ = std::unique_lock<std::mutex>(standing_->mutex_);
  cv::Mat& common = standing_->common_;
  if (common.empty()) common = standing_->depths_.clone();
  for (const cv::Rect& texels : standing_->changed_) {
    standing_->depths_(texels).copyTo(common(texels));
  }
  standing_->changed_.clear();
  for (const MapPiece& piece : pieces_) {
    cv::Mat here = common(piece.texels);
    cv::min(here, piece.depths, here);
    standing_->changed_.push_back(piece.texels);
  }
  result.depths_ = common;
  return result;
}

}  // namespace synthetic_dataset::render
