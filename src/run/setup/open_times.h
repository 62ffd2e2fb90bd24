#pragma once

#include "run/setup/motion_setup.h"

namespace synthetic_dataset::run {

/// Notes pictures that are exposed, and sweeps that are measured, for longer than the shortest time
/// from one scene to the next: physics goes forward alone.
/// @param setup  with its scenes, as far as they could be found; gets what is wrong
void checkOpenTimes(MotionSetup& setup);

}  // namespace synthetic_dataset::run
