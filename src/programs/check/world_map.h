#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "run/scene_sink.h"
#include "run/setup/motion_setup.h"

namespace synthetic_dataset::programs {

/// A motion from straight above, x to the right and y up: the world's ground and what stands on it,
/// the ways of all objects, where cameras stand and which way they look, a scale. CV_8UC3.
/// @param motion  whose world has been advanced
/// @param is_only  of the run: then its name says nothing
/// @param scenes  of the run, those of this motion among them
[[nodiscard]] cv::Mat worldMap(const run::MotionSetup& motion, bool is_only,
                               const std::vector<run::FinishedScene>& scenes);

}  // namespace synthetic_dataset::programs
