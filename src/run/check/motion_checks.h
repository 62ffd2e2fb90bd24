#pragma once

#include <vector>

#include "base/diagnostics.h"
#include "run/check/finding.h"
#include "run/setup/motion_setup.h"

namespace synthetic_dataset::run {

/// Finds oddities of a motion that can be detected without rendering, in a few milliseconds: scenes
/// closer together than the recording's own rate, objects whose frames are recorded and never move,
/// scenes in which nothing has moved since the previous one, objects as large as a building or as
/// small as a grain.
/// @param motion  without errors
[[nodiscard]] std::vector<Finding> checkSetup(const MotionSetup& motion);

/// If there are several motions, adds to each finding which one it concerns.
void nameMotion(const MotionSetup& motion, std::size_t motion_count,
                std::vector<Finding>& findings);

}  // namespace synthetic_dataset::run
