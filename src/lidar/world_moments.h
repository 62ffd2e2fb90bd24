#pragma once

#include <cstddef>
#include <vector>

#include "base/placement.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::lidar {

/// Where all that moves is at a time.
struct WorldMoment {
  Duration offset{0};                 ///< from the stamp
  std::vector<base::Placement> X_WL;  ///< of ScannedWorld::moving()
  std::vector<base::Placement> X_WS;  ///< of the lidars; only of those that ride on links
};

/// Two of some moments, by their indices, and how far a time is from one to the other, 0 .. 1; at
/// either end, one of them twice.
struct MomentsAround {
  std::size_t before = 0;
  std::size_t after = 0;
  double share = 0.0;
};

/// @param moments  ascending, at least one
/// @param time  from the stamp [ns]
[[nodiscard]] MomentsAround momentsAround(const std::vector<WorldMoment>& moments, double time);

/// Where something is at a time, between two moments.
/// @param moments  ascending, at least one
/// @param poses  X_WL or X_WS
/// @param time  from the stamp [ns]
[[nodiscard]] base::Placement placementAt(const std::vector<WorldMoment>& moments,
                                          std::vector<base::Placement> WorldMoment::*poses,
                                          std::size_t index, double time);

}  // namespace synthetic_dataset::lidar
