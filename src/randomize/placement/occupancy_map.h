#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace synthetic_dataset::randomize {

enum class Cell : std::uint8_t { kFree, kOccupied, kUnknown };

/// A map of more takes more memory than a machine should be asked for.
inline constexpr std::size_t kMostCells = std::size_t{1} << 28U;

/// Where a map lies: the pose of its frame M in the global frame G, turned about z alone.
struct MapPose {
  double x = 0.0;    ///< [m]
  double y = 0.0;    ///< [m]
  double z = 0.0;    ///< [m]
  double yaw = 0.0;  ///< [rad]
};

/// A floor in square cells of which it is known whether something stands on them. Its frame M has
/// the lower left cell's corner for its origin; columns follow M's x, rows M's y, from 0.
class OccupancyMap {
 public:
  /// @param width, height  [cells]
  /// @param resolution  of a cell's side [m]
  /// @param cells  row by row, the lowest first
  /// @throws Error when there is none or another number of them, a side is longer than a million
  ///     or all are more than kMostCells, or the resolution or the pose is none
  OccupancyMap(std::size_t width, std::size_t height, double resolution, const MapPose& X_GM,
               std::vector<Cell> cells);

  [[nodiscard]] std::size_t width() const { return width_; }    ///< [cells]
  [[nodiscard]] std::size_t height() const { return height_; }  ///< [cells]
  [[nodiscard]] double resolution() const { return resolution_; }
  [[nodiscard]] const MapPose& pose() const { return X_GM_; }

  /// @param column, row  that the map has
  [[nodiscard]] Cell cell(std::size_t column, std::size_t row) const {
    return cells_[row * width_ + column];
  }

  /// The cell below a place; nothing outside of the map.
  [[nodiscard]] std::optional<Cell> cellAt(const Eigen::Vector2d& p_G) const;

  /// Neither what is unknown nor what lies outside is free.
  [[nodiscard]] bool isFree(const Eigen::Vector2d& p_G) const { return cellAt(p_G) == Cell::kFree; }

  [[nodiscard]] Eigen::Vector2d toGlobal(const Eigen::Vector2d& p_M) const;
  [[nodiscard]] Eigen::Vector2d toMap(const Eigen::Vector2d& p_G) const;

 private:
  std::size_t width_;
  std::size_t height_;
  double resolution_;
  MapPose X_GM_;
  Eigen::Matrix2d R_GM_;
  std::vector<Cell> cells_;
};

}  // namespace synthetic_dataset::randomize
