#pragma once

#include <vector>

#include "base/diagnostics.h"
#include "run/check/finding.h"
#include "run/setup/motion_setup.h"

namespace synthetic_dataset::run {

/// What is odd about a motion and shows without a picture, in some milliseconds: scenes closer
/// together than the recording's own rate, objects whose frames are recorded and never move, scenes
/// in which nothing has moved since the one before, objects as large as a building or as small as a
/// grain.
/// @param motion  without errors
[[nodiscard]] std::vector<Finding> checkSetup(const MotionSetup& motion);

/// Where there are several motions, findings say of which one they are.
void nameMotion(const MotionSetup& motion, std::size_t motion_count,
                std::vector<Finding>& findings);

}  // namespace synthetic_dataset::run
