#pragma once

#include <cstdint>
#include <vector>

#include "base/placement.h"
#include "lidar/firing_plan.h"
#include "lidar/lidar_options.h"
#include "lidar/scanned_world.h"
#include "lidar/surface_hit.h"
#include "lidar/world_moments.h"
#include "synthetic_dataset/cloud.h"

namespace synthetic_dataset::lidar {

/// Where everything is while a scanner sweeps.
struct SweepMotion {
  std::vector<WorldMoment> moments;   ///< ascending, at least one
  std::vector<bool> present;          ///< by link
  std::vector<base::Placement> X_GS;  ///< at the start of each column, and at the sweep's end
  Pose X_GS_at_stamp = Pose::Identity();
};

/// Casts the rays of a sweep, each at its own time, on all of the processor's cores.
/// @param labels  of the world's links
/// @param seed  for noise and lost returns
[[nodiscard]] Cloud sweep(const ScannedWorld& world, const LidarModel& model,
                          const FiringPlan& plan, const SweepMotion& motion,
                          const std::vector<LinkLabel>& labels, const Paint& paint,
                          std::uint64_t seed);

}  // namespace synthetic_dataset::lidar
