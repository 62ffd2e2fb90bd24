#pragma once

#include <vector>

#include "base/diagnostics.h"
#include "run/setup/motion_setup.h"

namespace synthetic_dataset::run {

/// Adds an error for each motion that differs from the first one in something that a dataset has
/// only one set of: cameras and lidars, labelled distractors, the names of world classes.
/// @param motions  at least one
void checkMotionsCompatible(const std::vector<MotionSetup>& motions,
                            base::Diagnostics& diagnostics);

}  // namespace synthetic_dataset::run
