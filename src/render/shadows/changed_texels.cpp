#include "render/shadows/changed_texels.h"

#include <algorithm>
#include <cstddef>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace synthetic_dataset::render {
namespace {

constexpr int kCell = ChangedTexels::kCell;

int cellOf(int texel) {
  return texel >= 0 ? texel / kCell : -((kCell - 1 - texel) / kCell);  // rounded down
}

/// The cells of some texels, and those within reach of them.
/// @param reach  [cell]
cv::Rect cellsAround(const cv::Rect& texels, const cv::Size& reach) {
  return {cv::Point(cellOf(texels.x) - reach.width, cellOf(texels.y) - reach.height),
          cv::Point(cellOf(texels.x + texels.width - 1) + 1 + reach.width,
                    cellOf(texels.y + texels.height - 1) + 1 + reach.height)};
}

cv::Size cellsIn(const cv::Size& texels) {
  return {(texels.width + kCell - 1) / kCell, (texels.height + kCell - 1) / kCell};
}

/// Marks the cells in which a piece is nearer to the light than what never moves.
/// @param standing  CV_32FC1: the whole map of what never moves
/// @param place  of the cells
void markNearer(const MapPiece& piece, const cv::Mat& standing, const cv::Rect& place,
                cv::Mat& cells) {
  static_assert(kCell == kLaneCount);
  const int left = piece.texels.x;
  const int end = left + piece.texels.width;
  for (int row = piece.texels.y; row < piece.texels.y + piece.texels.height; ++row) {
    const auto* cast = piece.depths.ptr<float>(row - piece.texels.y);
    const auto* behind = standing.ptr<float>(row);
    auto* marked = cells.ptr<unsigned char>(cellOf(row) - place.y);
    for (int cell = cellOf(left); cell * kCell < end; ++cell) {
      unsigned char& mark = marked[cell - place.x];
      if (mark != 0) continue;
      const int first = std::max(cell * kCell, left);
      const int last = std::min((cell + 1) * kCell, end);
      bool is_nearer = false;
      if (last - first == kCell) {
        is_nearer = cv::v_check_any(cv::v_load(cast + first - left) < cv::v_load(behind + first));
      } else {
        for (int column = first; column < last; ++column) {
          is_nearer = is_nearer || cast[column - left] < behind[column];
        }
      }
      if (is_nearer) mark = 255;
    }
  }
}

/// Extends the marked cells on all sides. If that is far, marks all cells, which takes less time.
void grow(cv::Mat& cells, const cv::Size& by) {
  constexpr int kFar = 16;
  if (std::max(by.width, by.height) > kFar) {
    cells.setTo(255);
    return;
  }
  const cv::Size window(2 * by.width + 1, 2 * by.height + 1);
  cv::dilate(cells, cells, cv::getStructuringElement(cv::MORPH_RECT, window));
}

}  // namespace

ChangedTexels allChanged(const cv::Rect& map, const cv::Size& reach,
                         const Eigen::Matrix4d& texels_from_world) {
  // Surfaces outside the map may be raised onto it.
  const cv::Rect place = cellsAround(map, cellsIn(reach));
  return {texels_from_world, place, cv::Mat(place.size(), CV_8UC1, cv::Scalar(255))};
}

ChangedTexels changedBy(const std::vector<MapPiece>& moving, const cv::Mat& standing,
                        const cv::Size& reach, const Eigen::Matrix4d& texels_from_world) {
  const cv::Size cell_reach = cellsIn(reach);
  const auto placeOf = [&](const MapPiece& piece) { return cellsAround(piece.texels, cell_reach); };
  std::vector<cv::Mat> cells(moving.size());
  cv::parallel_for_(cv::Range(0, static_cast<int>(cells.size())), [&](const cv::Range& some) {
    for (auto i = static_cast<std::size_t>(some.start); i < static_cast<std::size_t>(some.end);
         ++i) {
      const cv::Rect place = placeOf(moving[i]);
      cells[i] = cv::Mat::zeros(place.size(), CV_8UC1);
      markNearer(moving[i], standing, place, cells[i]);
      grow(cells[i], cell_reach);
    }
  });
  ChangedTexels changed{texels_from_world, {}, {}};
  for (const MapPiece& piece : moving) changed.place |= placeOf(piece);
  changed.cells = cv::Mat::zeros(changed.place.size(), CV_8UC1);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    cv::Mat target = changed.cells(placeOf(moving[i]) - changed.place.tl());
    target |= cells[i];
  }
  return changed;
}

}  // namespace synthetic_dataset::render
