#pragma once

#include <cstddef>
#include <vector>

#include "base/placement.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::lidar {

/// Where everything that moves is at a given time.
struct WorldMoment {
  Duration offset{0};                 ///< from the stamp
  std::vector<base::Placement> X_WL;  ///< of ScannedWorld::moving()
  std::vector<base::Placement> X_WS;  ///< of the lidars; valid only for those on links
};

/// The indices of the two moments around a time, and how far the time is from the first to the
/// second, 0 .. 1; before the first moment and after the last, both are the same one.
struct MomentsAround {
  std::size_t before = 0;
  std::size_t after = 0;
  double share = 0.0;
};

/// @param moments  ascending, at least one
/// @param time  from the stamp [ns]
[[nodiscard]] MomentsAround momentsAround(const std::vector<WorldMoment>& moments, double time);

/// The pose of something at a given time, interpolated between two moments.
/// @param moments  ascending, at least one
/// @param poses  X_WL or X_WS
/// @param time  from the stamp [ns]
[[nodiscard]] base::Placement placementAt(const std::vector<WorldMoment>& moments,
                                          std::vector<base::Placement> WorldMoment::*poses,
                                          std::size_t index, double time);

}  // namespace synthetic_dataset::lidar
