#pragma once

#include <vector>

#include "run/check/finding.h"
#include "run/check/moments.h"
#include "run/check/named_rays.h"

namespace synthetic_dataset::run {

/// Objects with nothing below them, and such as stand in the ground or above it all the time.
/// @param rays  of the motion's world
[[nodiscard]] std::vector<Finding> checkStanding(const MotionSetup& motion, const NamedRays& rays,
                                                 const std::vector<Moment>& moments);

}  // namespace synthetic_dataset::run
