#include "render/shadows/map_depths.h"

#include <opencv2/core.hpp>

#include "render/pixels/lanes.h"

namespace synthetic_dataset::render {
namespace {

/// The least depth of some texels, which are at most as many as those of a cell.
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

/// Updates the least depths of all cells that contain some texels.
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

void MapDepths::Standing::keep() {
  const std::unique_lock<std::mutex> lock(mutex_);
  if (isKept()) return;
  remove();
  common_ = depths_.clone();
}

/// Removes all pieces from the common map, which then has only what never moves.
void MapDepths::Standing::remove() {
  // The last piece first, as they may overlap.
  for (auto piece = beneath_.rbegin(); piece != beneath_.rend(); ++piece) {
    (isKept() ? depths_(piece->texels) : piece->depths).copyTo(common_(piece->texels));
    if (!nearest_.empty()) findNearestOf(common_, piece->texels, nearest_);
  }
  beneath_.clear();
}

/// Makes the common map that of what never moves, with these pieces on it.
void MapDepths::Standing::putOn(const std::vector<MapPiece>& pieces) {
  remove();
  for (const MapPiece& piece : pieces) {
    cv::Mat here = common_(piece.texels);
    beneath_.push_back({piece.texels, isKept() ? cv::Mat() : here.clone()});
    cv::min(here, piece.depths, here);
  }
  if (nearest_.empty()) return;
  for (const MapPiece& piece : pieces) findNearestOf(common_, piece.texels, nearest_);
}

void MapDepths::Standing::findNearest() {
  if (!nearest_.empty()) return;
  const auto cells = [](int texels) { return (texels + kCell - 1) / kCell; };
  nearest_ = cv::Mat(cells(common_.rows), cells(common_.cols), CV_32FC1);
  findNearestOf(common_, cv::Rect({}, common_.size()), nearest_);
}

MapDepths::Assembled MapDepths::assemble(bool with_nearest) const {
  Assembled result;
  result.lock_ = std::unique_lock<std::mutex>(standing_->mutex_);
  if (pieces_.empty() && !with_nearest && standing_->isKept()) {
    result.depths_ = standing_->depths_;
    result.lock_.unlock();
    return result;
  }
  standing_->putOn(pieces_);
  result.depths_ = standing_->common_;
  if (with_nearest) {
    standing_->findNearest();
    result.nearest_ = standing_->nearest_;
  }
  return result;
}

}  // namespace synthetic_dataset::render
