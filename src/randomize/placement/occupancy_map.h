#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace synthetic_dataset::randomize {

enum class Cell : std::uint8_t { kFree, kOccupied, kUnknown };

/// The largest map accepted; more cells would take too much memory.
inline constexpr std::size_t kMostCells = std::size_t{1} << 28U;

/// Where a map lies: the pose of its frame M in the global frame G, rotated only about z.
struct MapPose {
  double x = 0.0;    ///< [m]
  double y = 0.0;    ///< [m]
  double z = 0.0;    ///< [m]
  double yaw = 0.0;  ///< [rad]
};

/// A floor divided into square cells, with what is known about whether something stands on each.
/// The origin of its frame M is the corner of the lower left cell; columns follow M's x, rows M's
/// y, from 0.
class OccupancyMap {
 public:
  /// @param width, height  [cells]
  /// @param resolution  side of a cell [m]
  /// @param cells  row by row, starting with the lowest
  /// @throws Error if there are no cells or the wrong number of them, a side exceeds a million
  ///     cells, there are more than kMostCells, or the resolution or the pose is invalid
  OccupancyMap(std::size_t width, std::size_t height, double resolution, const MapPose& X_GM,
               std::vector<Cell> cells);

  [[nodiscard]] std::size_t width() const { return width_; }    ///< [cells]
  [[nodiscard]] std::size_t height() const { return height_; }  ///< [cells]
  [[nodiscard]] double resolution() const { return resolution_; }
  [[nodiscard]] const MapPose& pose() const { return X_GM_; }

  /// @param column, row  must be inside the map
  [[nodiscard]] Cell cell(std::size_t column, std::size_t row) const {
    return cells_[row * width_ + column];
  }

  /// The cell below a place; nothing outside the map.
  [[nodiscard]] std::optional<Cell> cellAt(const Eigen::Vector2d& p_G) const;

  /// Unknown cells and places outside the map are not free.
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
