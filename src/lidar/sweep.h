#pragma once

#include <cstdint>
#include <vector>

#include "base/placement.h"
#include "lidar/firing_plan.h"
#include "lidar/lidar_options.h"
#include "lidar/scanned_world.h"
#include "synthetic_dataset/cloud.h"

namespace synthetic_dataset::lidar {

/// What the labels of a link's points are.
struct LinkLabel {
  std::uint16_t instance = 0;
  std::uint16_t class_number = 0;
  std::uint16_t world_class = 0;
  std::uint16_t part = 0;
};

/// Where all that moves is at a time.
struct WorldMoment {
  Duration offset{0};                 ///< from the stamp
  std::vector<base::Placement> X_WL;  ///< of ScannedWorld::moving()
  std::vector<base::Placement> X_WS;  ///< of the lidars; only of those that ride on links
};

/// Where something is at a time, between two moments.
/// @param poses  X_WL or X_WS
/// @param time  from the stamp [ns]
[[nodiscard]] base::Placement placementAt(const std::vector<WorldMoment>& moments,
                                          std::vector<base::Placement> WorldMoment::*poses,
                                          std::size_t index, double time);

/// Where everything is while a scanner sweeps.
struct SweepMotion {
  std::vector<WorldMoment> moments;   ///< ascending, at least one
  std::vector<bool> present;          ///< the links that are there
  std::vector<base::Placement> X_GS;  ///< at the begin of each column, and at the sweep's end
  Pose X_GS_at_stamp = Pose::Identity();
};

/// Casts the rays of a sweep, each at its own time, with all of the processor's cores.
/// @param labels  of the world's links
/// @param seed  of noise and lost returns
[[nodiscard]] Cloud sweep(const ScannedWorld& world, const LidarModel& model,
                          const FiringPlan& plan, const SweepMotion& motion,
                          const std::vector<LinkLabel>& labels, const Paint& paint,
                          std::uint64_t seed);

}  // namespace synthetic_dataset::lidar
