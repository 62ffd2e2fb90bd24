#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::render {

/// Where a shadow map differs from that of what never moves alone, and the texels round it, as far
/// as a surface's light asks for them. In cells of several texels, for what is looked at in any
/// order should be small.
struct ChangedTexels {
  static constexpr int kCell = 4;  ///< [texel] of a cell's side

  Eigen::Matrix4d texels_from_world;  ///< to w times column, w times row, (anything,) w
  cv::Rect place;                     ///< of these cells in the map; nothing has changed beside it
  cv::Mat cells;                      ///< CV_8UC1: 255 for those that have changed

  [[nodiscard]] bool isChanged(float column, float row) const {
    const float x = column / kCell - static_cast<float>(place.x);
    const float y = row / kCell - static_cast<float>(place.y);
    return x >= 0.0F && y >= 0.0F && x < static_cast<float>(place.width) &&
           y < static_cast<float>(place.height) &&
           cells.at<unsigned char>(static_cast<int>(y), static_cast<int>(x)) != 0;
  }
};

}  // namespace synthetic_dataset::render
