#pragma once

#include <vector>

#include "base/diagnostics.h"
#include "lidar/lidar_rig.h"
#include "synthetic_dataset/pose.h"
#include "world/world.h"

namespace synthetic_dataset::run {

/// The scenes for which each lidar of recorded clouds has one; how many others there were is noted.
/// @param scenes  ascending
/// @throws Error naming the setting where there is none
[[nodiscard]] std::vector<Stamp> scenesWithClouds(const std::vector<lidar::LidarRig>& lidars,
                                                  std::vector<Stamp> scenes,
                                                  base::Diagnostics& diagnostics);

/// Notes clouds that cannot be read, and sweeps that begin while the one of the scene before goes
/// on, where physics moves something: it goes forward alone. Stamps are not exact, so an
/// overlap of less than 5 ms is allowed: the world then stays as the scene before has left it.
/// @param scenes  ascending
void checkClouds(const std::vector<lidar::LidarRig>& lidars, const std::vector<Stamp>& scenes,
                 const world::World& world, base::Diagnostics& diagnostics);

}  // namespace synthetic_dataset::run
