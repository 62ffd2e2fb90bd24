#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "run/scene_sink.h"
#include "run/setup/motion_setup.h"

namespace synthetic_dataset::programs {

/// A map of a motion, seen from straight above, x to the right and y up: the world's ground and
/// what stands on it, the paths of all objects, the cameras' positions and viewing directions, and
/// a scale. CV_8UC3.
/// @param motion  one whose world has been advanced
/// @param is_only  whether it is the run's only motion: its name is then left out
/// @param scenes  all of the run's; those of other motions are ignored
[[nodiscard]] cv::Mat worldMap(const run::MotionSetup& motion, bool is_only,
                               const std::vector<run::FinishedScene>& scenes);

}  // namespace synthetic_dataset::programs
