#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "render/pixels/lanes.h"
#include "render/shadows/map_depths.h"

namespace synthetic_dataset::render {

/// Where a shadow map differs from the one that only has what never moves, extended by as many
/// texels as a surface's light lookup reaches. Stored in cells of several texels, as data that is
/// accessed randomly should be small.
struct ChangedTexels {
  static constexpr int kCell = 4;  ///< [texel] of a cell's side

  Eigen::Matrix4d texels_from_world;  ///< to w times column, w times row, (unused,) w
  cv::Rect place;                     ///< of the cells, in the map; nothing has changed outside it
  cv::Mat cells;                      ///< CV_8UC1: 255 for cells that have changed

  /// Which of four places in the map have changed: a bit for each.
  /// @param wanted  a bit for each place to test
  [[nodiscard]] int changed(const Lanes& columns, const Lanes& rows, int wanted) const {
    const Lanes x = columns / lanes(kCell) - lanes(static_cast<float>(place.x));
    const Lanes y = rows / lanes(kCell) - lanes(static_cast<float>(place.y));
    const Lanes is_within = (x >= lanes(0.0F)) & (x < lanes(static_cast<float>(place.width))) &
                            (y >= lanes(0.0F)) & (y < lanes(static_cast<float>(place.height)));
    wanted &= cv::v_signmask(is_within);
    if (wanted == 0) return 0;
    std::array<int, kLaneCount> cell_columns{};
    std::array<int, kLaneCount> cell_rows{};
    cv::v_store(cell_columns.data(), cv::v_trunc(x));
    cv::v_store(cell_rows.data(), cv::v_trunc(y));
    int found = 0;
    for (std::size_t i = 0; i < kLaneCount; ++i) {
      const int bit = wanted & 1 << i;
      if (bit != 0 && cells.at<unsigned char>(cell_rows[i], cell_columns[i]) != 0) found |= bit;
    }
    return found;
  }
};

/// The result if nothing is known about the previous map: everything has changed.
/// @param map  all texels
/// @param reach  how many columns and rows from its own place a surface's light lookup reaches
[[nodiscard]] ChangedTexels allChanged(const cv::Rect& map, const cv::Size& reach,
                                       const Eigen::Matrix4d& texels_from_world);

/// Where what moves is nearer to the light than what never moves.
/// @param standing  CV_32FC1: the whole map of what never moves
[[nodiscard]] ChangedTexels changedBy(const std::vector<MapPiece>& moving, const cv::Mat& standing,
                                      const cv::Size& reach,
                                      const Eigen::Matrix4d& texels_from_world);

}  // namespace synthetic_dataset::render
