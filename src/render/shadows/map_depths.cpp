#include "render/shadows/map_depths.h"

#include <utility>

#include <opencv2/core.hpp>

#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {
namespace {

/// The least depth of some texels, at most as many as a cell has.
float nearestOf(const cv::Mat& depths, const cv::Rect& texels) {
  static_assert(MapDepths::kCell == kLaneCount);
  if (texels.width == kLaneCount) {
    Lanes least = lanes(1.0F);
    for (int row = texels.y; row < texels.y + texels.height; ++row) {
      least = cv::v_min(least, cv::v_load(depths.ptr<float>(row) + texels.x));
    }
    return cv::v_reduce_min(least);
  }
  double least = 0.0;
  cv::minMaxLoc(depths(texels), &least);
  return static_cast<float>(least);
}

/// Finds the least depths again of all cells that some texels are in.
void findNearestOf(const cv::Mat& depths, const cv::Rect& texels, cv::Mat& nearest) {
  const cv::Rect map({}, depths.size());
  for (int row = texels.y / MapDepths::kCell; MapDepths::kCell * row < texels.y + texels.height;
       ++row) {
    auto* found = nearest.ptr<float>(row);
    for (int cell = texels.x / MapDepths::kCell; MapDepths::kCell * cell < texels.x + texels.width;
         ++cell) {
      found[cell] = nearestOf(depths, cv::Rect(MapDepths::kCell * cell, MapDepths::kCell * row,
                                               MapDepths::kCell, MapDepths::kCell) &
                                          map);
    }
  }
}

}  // namespace

/// Makes the common map that of what never moves, with these. It is a copy once there are any.
void MapDepths::Standing::putOn(const std::vector<MapPiece>& pieces) {
  if (common_.empty()) common_ = depths_;
  if (!pieces.empty() && common_.data == depths_.data) common_ = depths_.clone();
  for (const cv::Rect& texels : changed_) depths_(texels).copyTo(common_(texels));
  std::vector<cv::Rect> passed = std::exchange(changed_, {});
  for (const MapPiece& piece : pieces) {
    cv::Mat here = common_(piece.texels);
    cv::min(here, piece.depths, here);
    changed_.push_back(piece.texels);
  }
  if (nearest_.empty()) return;
  for (const cv::Rect& texels : passed) findNearestOf(common_, texels, nearest_);
  for (const cv::Rect& texels : changed_) findNearestOf(common_, texels, nearest_);
}

void MapDepths::Standing::findNearest() {
  if (!nearest_.empty()) return;
  const auto cells = [](int texels) { return (texels + kCell - 1) / kCell; };
  nearest_ = cv::Mat(cells(common_.rows), cells(common_.cols), CV_32FC1);
  findNearestOf(common_, cv::Rect({}, common_.size()), nearest_);
}

MapDepths::Assembled MapDepths::assemble(bool with_nearest) const {
  Assembled result;
  if (pieces_.empty() && !with_nearest) {
    result.depths_ = standing_->depths_;
    return result;
  }
  result.lock_ = std::unique_lock<std::mutex>(standing_->mutex_);
  standing_->putOn(pieces_);
  result.depths_ = standing_->common_;
  if (with_nearest) {
    standing_->findNearest();
    result.nearest_ = standing_->nearest_;
  }
  return result;
}

}  // namespace synthetic_dataset::render
