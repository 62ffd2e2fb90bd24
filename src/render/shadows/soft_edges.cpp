#include "render/shadows/soft_edges.h"

#include <algorithm>
#include <cmath>

#include "render/shadows/map_row.h"
#include "render/shadows/shadow_projection.h"

namespace synthetic_dataset::render {
namespace {

/// The sharpest that an edge can be [texel]: half the width of the square that is looked up for
/// hard edges.
constexpr float kSharpest = 1.5F;

Lanes fourFrom(float first) { return lanes(first) + Lanes(0.0F, 1.0F, 2.0F, 3.0F); }

}  // namespace

float SoftEdges::passing(const PlaceInMap& place) const {
  const Eigen::Vector2f disc = discOf(gapBefore(place));
  return disc.maxCoeff() > kSharpest ? soft(place, disc) : sharp(place);
}

/// Half the extent in the map of the light's disc, seen past an occluder that is nearer to the
/// light by `depth`.
Eigen::Vector2f SoftEdges::discOf(float depth) const {
  return (softness_ * depth).cwiseMax(kSharpest).cwiseMin(static_cast<float>(kWidestSoftness));
}

/// By how much of the map's depth occluders are in front of the surface: the mean over the cells in
/// which there is an occluder; 0 if there are none.
float SoftEdges::gapBefore(const PlaceInMap& place) const {
  constexpr float kCell = MapDepths::kCell;
  constexpr float kWithin = 0.5F * (kCell - 1.0F);  // from a cell's middle to its texels
  const Eigen::Vector2f around = discOf(place.depth);
  const auto cellOf = [](float texel) { return static_cast<int>(std::floor(texel / kCell)); };
  const int first_column = std::max(cellOf(place.column - around.x()), 0);
  const int last_column = std::min(cellOf(place.column + around.x()), nearest_.cols - 1);
  const int first_row = std::max(cellOf(place.row - around.y()), 0);
  const int last_row = std::min(cellOf(place.row + around.y()), nearest_.rows - 1);
  const float slack = kWithin * (std::abs(place.depth_by_column) + std::abs(place.depth_by_row));
  const Lanes zero = lanes(0.0F);
  Lanes sum = zero;
  Lanes count = zero;
  for (int row = first_row; row <= last_row; ++row) {
    const float down = kCell * (static_cast<float>(row) + 0.5F) - place.row;
    const float here = place.depth + place.depth_by_row * down - slack;
    const MapRow cells_of_row(nearest_, row);
    for (int column = first_column; column <= last_column; column += kLaneCount) {
      const Lanes cells = fourFrom(static_cast<float>(column));
      const Lanes across = lanes(kCell) * (cells + lanes(0.5F)) - lanes(place.column);
      const Lanes gap =
          lanes(here) + lanes(place.depth_by_column) * across - cells_of_row.four(column);
      const Lanes hides = (gap > zero) & (cells <= lanes(static_cast<float>(last_column)));
      sum += gap & hides;
      count += lanes(1.0F) & hides;
    }
  }
  const float found = cv::v_reduce_sum(count);
  return found > 0.0F ? cv::v_reduce_sum(sum) / found : 0.0F;
}

/// The share of a square in which the map's texels are not nearer to the light than the surface.
float SoftEdges::sharp(const PlaceInMap& place) const {
  constexpr float kSide = 2.0F * kSharpest;
  const auto first = static_cast<float>(std::floor(place.column - kSharpest));
  const Lanes columns = fourFrom(first);
  const Lanes low = lanes(place.column - kSharpest);
  const Lanes high = lanes(place.column + kSharpest);
  const Lanes one = lanes(1.0F);
  const Lanes inside = cv::v_min(columns + one, high) - cv::v_max(columns, low);
  const Lanes depths =
      lanes(place.depth) + lanes(place.depth_by_column) * (columns + lanes(0.5F - place.column));
  const auto first_row = static_cast<float>(std::floor(place.row - kSharpest));
  Lanes sum = lanes(0.0F);
  for (int i = 0; i < kLaneCount; ++i) {
    const float row = first_row + static_cast<float>(i);
    const float share =
        std::min(row + 1.0F, place.row + kSharpest) - std::max(row, place.row - kSharpest);
    const Lanes depth =
        cv::v_min(depths + lanes(place.depth_by_row * (row + 0.5F - place.row)), one);
    const Lanes there = MapRow(depths_, static_cast<int>(row)).four(static_cast<int>(first));
    sum += (inside & (depth <= there)) * lanes(share);
  }
  return cv::v_reduce_sum(sum) / (kSide * kSide);
}

/// The share of a disc in which the map's texels are not nearer to the light than the surface.
float SoftEdges::soft(const PlaceInMap& place, const Eigen::Vector2f& disc) const {
  const Lanes zero = lanes(0.0F);
  const Lanes one = lanes(1.0F);
  Lanes sum = zero;
  float all = 0.0F;
  const int last_row = static_cast<int>(std::floor(place.row + disc.y()));
  for (int row = static_cast<int>(std::floor(place.row - disc.y())); row <= last_row; ++row) {
    const float down = static_cast<float>(row) + 0.5F - place.row;
    const float share = 1.0F - down * down / (disc.y() * disc.y());
    if (share <= 0.0F) continue;
    const float half = disc.x() * std::sqrt(share);
    all += 2.0F * half;
    const Lanes low = lanes(place.column - half);
    const Lanes high = lanes(place.column + half);
    const Lanes here = lanes(place.depth + place.depth_by_row * down);
    const MapRow texels(depths_, row);
    const auto end = static_cast<int>(std::ceil(place.column + half));
    for (int column = static_cast<int>(std::floor(place.column - half)); column < end;
         column += kLaneCount) {
      const Lanes first = fourFrom(static_cast<float>(column));
      const Lanes inside = cv::v_max(cv::v_min(first + one, high) - cv::v_max(first, low), zero);
      const Lanes across = first + lanes(0.5F) - lanes(place.column);
      const Lanes depth = cv::v_min(here + lanes(place.depth_by_column) * across, one);
      sum += inside & (depth <= texels.four(column));
    }
  }
  return all > 0.0F ? cv::v_reduce_sum(sum) / all : 1.0F;
}

}  // namespace synthetic_dataset::render
