#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "lidar/lidar_options.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::lidar {

/// When and in which direction a scanner sends its rays: a sweep of columns, each with one ray per
/// ring. The middle of the sweep is at the scene's stamp.
class FiringPlan {
 public:
  /// @param model  with at least one ring and one column
  explicit FiringPlan(const LidarModel& model);

  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rings() const { return static_cast<int>(elevations_.size()); }

  /// How long the sweep takes.
  [[nodiscard]] Duration length() const { return length_; }

  /// When a column begins, relative to the stamp. One column past the last is allowed: the sweep's
  /// end.
  [[nodiscard]] Duration columnTime(int column) const;

  /// When a ring fires, as a fraction of the time from its column to the next one, 0 .. 1.
  [[nodiscard]] double share(int ring) const { return shares_[static_cast<std::size_t>(ring)]; }

  /// The direction of a ray in the scanner's frame at the time of firing; length 1. The scanner
  /// keeps turning while a column's rings fire.
  [[nodiscard]] Eigen::Vector3d direction(int column, int ring) const;

 private:
  int columns_;
  Duration length_;
  double first_azimuth_;
  double azimuth_step_;
  double steps_;                                   ///< columns from the sweep's start to its end
  std::vector<std::array<double, 2>> elevations_;  ///< cosine and sine, of each ring
  std::vector<std::array<double, 2>> azimuths_;    ///< of each column, if all rings share it
  std::vector<double> azimuth_offsets_;
  std::vector<double> shares_;
};

}  // namespace synthetic_dataset::lidar
