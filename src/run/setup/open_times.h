#pragma once

#include "run/setup/motion_setup.h"

namespace synthetic_dataset::run {

/// Reports pictures whose exposure, and lidar sweeps whose duration, is longer than the shortest
/// time from one scene to the next: physics only moves forward.
/// @param setup  with its scenes, as far as they could be determined; problems are added to its
///     diagnostics
void checkOpenTimes(MotionSetup& setup);

}  // namespace synthetic_dataset::run
