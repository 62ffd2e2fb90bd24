#pragma once

#include <cstdint>
#include <vector>

#include "run/setup/motion_setup.h"

namespace synthetic_dataset::run {

/// How many objects of each of the run's classes, in their order, are in view at a time, in all
/// cameras' images.
using ClassCounts = std::vector<std::int64_t>;

/// The labels that a recording's scenes would about have, at each of its times: boxes of objects
/// that reach into the image, whatever hides them. Nothing is drawn for it. Cameras that are put
/// somewhere anew for each scene look at objects there, and do not count.
/// @return nothing where scenes are placed at random, or a part of the motion is not there
[[nodiscard]] std::vector<ClassCounts> expectedLabels(const MotionSetup& motion);

}  // namespace synthetic_dataset::run
