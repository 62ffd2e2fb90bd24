#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "base/random/random_source.h"
#include "randomize/placement/occupancy_map.h"

namespace synthetic_dataset::randomize {

/// Where on a map the centre of a disc can lie so that the disc comes near to no cell that is not
/// free, and stays in the map.
///
/// Hart, Goodman and O'Shea look at the cells of a circle that Bresenham's algorithm draws about
/// the centre's cell, and of the lines between its points: whole rows of cells. These are rows of
/// cells too, but those of the disc itself about a place within the cell: exact, and so every
/// place that is clear can be drawn and no other.
class FreePlaces {
 public:
  /// @param safety_radius  of the disc [m], at least 0; a disc of 0 m is a point on a free cell
  FreePlaces(OccupancyMap map, double safety_radius);

  /// The number of cells that may have clear places: all that do, and few others. 0: no place.
  [[nodiscard]] std::size_t cellCount() const { return cells_.size(); }

  /// Whether a place is on a free cell, and the disc about it is clear: no cell that is not free,
  /// and nothing outside of the map, is nearer than the radius.
  [[nodiscard]] bool isClear(const Eigen::Vector2d& p_G) const;

  /// A random place, each that is clear as likely as the others.
  /// @param tries  how many places are chosen at most until one is clear
  /// @return nothing when none of them was
  [[nodiscard]] std::optional<Eigen::Vector2d> draw(base::RandomSource& random, int tries) const;

 private:
  /// Lengths are in cells here.
  [[nodiscard]] bool isDiscClear(const Eigen::Vector2d& centre) const;
  [[nodiscard]] bool isRowFree(std::size_t row, double from, double to) const;

  OccupancyMap map_;
  double radius_;                   ///< [cells]
  std::vector<std::size_t> cells_;  ///< row * width + column of those that may have clear places
};

/// The radius [m] of the largest disc that fits on a map, up to a cell's side too small and never
/// too large: any that is smaller has places. 0 without a free cell.
[[nodiscard]] double largestClearance(const OccupancyMap& map);

}  // namespace synthetic_dataset::randomize
