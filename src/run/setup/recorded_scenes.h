#pragma once

#include <vector>

#include "base/diagnostics.h"
#include "lidar/lidar_rig.h"
#include "synthetic_dataset/pose.h"
#include "world/world.h"

namespace synthetic_dataset::run {

/// The scenes for which every lidar with recorded clouds has one; notes how many scenes are
/// dropped.
/// @param scenes  ascending
/// @throws Error naming the setting if there is none
[[nodiscard]] std::vector<Stamp> scenesWithClouds(const std::vector<lidar::LidarRig>& lidars,
                                                  std::vector<Stamp> scenes,
                                                  base::Diagnostics& diagnostics);

/// Notes clouds that cannot be read, and, if physics moves something, sweeps that begin during the
/// previous scene's sweep: physics only moves forward. Stamps are not exact, so an overlap of less
/// than 5 ms is allowed: the world then stays as the previous scene left it.
/// @param scenes  ascending
void checkClouds(const std::vector<lidar::LidarRig>& lidars, const std::vector<Stamp>& scenes,
                 const world::World& world, base::Diagnostics& diagnostics);

}  // namespace synthetic_dataset::run
