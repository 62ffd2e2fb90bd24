#pragma once

#include <cstdint>
#include <vector>

#include "run/setup/motion_setup.h"

namespace synthetic_dataset::run {

/// How many objects of each of the run's classes, in their order, are in view at a time, in all
/// cameras' images.
using ClassCounts = std::vector<std::int64_t>;

/// Estimates the labels of a recording's scenes, at each of its times: objects whose boxes reach
/// into the image, ignoring occlusion. Nothing is drawn for this. Cameras that are placed anew for
/// each scene are aimed at objects, and do not count.
/// @return nothing if scenes are placed at random, or if a part of the motion is missing
[[nodiscard]] std::vector<ClassCounts> expectedLabels(const MotionSetup& motion);

}  // namespace synthetic_dataset::run
