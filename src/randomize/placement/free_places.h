#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "base/random/random_source.h"
#include "randomize/placement/occupancy_map.h"

namespace synthetic_dataset::randomize {

/// Where on a map the centre of a disc can be so that the disc stays inside the map and overlaps no
/// cell that is not free.
///
/// Hart, Goodman and O'Shea check the cells of a circle that Bresenham's algorithm draws about the
/// centre's cell, and of the lines between its points: whole rows of cells. This class also checks
/// rows of cells, but those of the disc itself about a place within the cell. That is exact, so
/// every clear place can be drawn and no other.
class FreePlaces {
 public:
  /// @param safety_radius  of the disc [m], at least 0; a disc of 0 m is a point on a free cell
  FreePlaces(OccupancyMap map, double safety_radius);

  /// The number of cells that may have clear places: all those that do, and a few others. 0 means
  /// that there is no place.
  [[nodiscard]] std::size_t cellCount() const { return cells_.size(); }

  /// Whether a place is on a free cell and the disc about it is clear: no cell that is not free,
  /// and nothing outside the map, is closer than the radius.
  [[nodiscard]] bool isClear(const Eigen::Vector2d& p_G) const;

  /// Draws a random place; all clear places are equally likely.
  /// @param tries  the maximum number of places to try
  /// @return nothing if none of them was clear
  [[nodiscard]] std::optional<Eigen::Vector2d> draw(base::RandomSource& random, int tries) const;

 private:
  /// The lengths are in cells.
  [[nodiscard]] bool isDiscClear(const Eigen::Vector2d& centre) const;
  [[nodiscard]] bool isRowFree(std::size_t row, double from, double to) const;

  OccupancyMap map_;
  double radius_;                   ///< [cells]
  std::vector<std::size_t> cells_;  ///< row * width + column of those that may have clear places
};

/// The radius [m] of the largest disc that fits on a map, too small by at most a cell's side and
/// never too large: any smaller disc has places. 0 if there is no free cell.
[[nodiscard]] double largestClearance(const OccupancyMap& map);

}  // namespace synthetic_dataset::randomize
