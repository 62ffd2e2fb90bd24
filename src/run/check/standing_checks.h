#pragma once

#include <vector>

#include "run/check/finding.h"
#include "run/check/moments.h"
#include "run/check/named_rays.h"

namespace synthetic_dataset::run {

/// Finds objects with nothing below them, and objects that are always sunk into the ground or above
/// it.
/// @param rays  of the motion's world
[[nodiscard]] std::vector<Finding> checkStanding(const MotionSetup& motion, const NamedRays& rays,
                                                 const std::vector<Moment>& moments);

}  // namespace synthetic_dataset::run
