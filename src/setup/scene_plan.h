#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "config/config.h"
#include "motion/frame_motion.h"
#include "scene/articulation.h"
#include "scene/camera_rig.h"

namespace synthetic_dataset {

/// The times at which scenes are made: those of the timeline at which all objects and cameras are
/// known, over the whole exposure of each picture.
/// @param frames  with a recording
/// @throws ErrorList when there is none, saying why
[[nodiscard]] motion::Timeline planScenes(
    const motion::FrameMotion& frame_motion, const config::Config& config,
    const std::vector<CameraRig>& cameras,
    const std::vector<std::vector<DrivenLinks>>& driven_links);

/// The least time that there may be from one scene to the next.
[[nodiscard]] Duration shortestPeriod(const config::Config& config);

/// The times of scenes that stand for themselves: as many as are asked for, one a period, from one
/// period after 0 on.
[[nodiscard]] motion::Timeline planUnrelatedScenes(const config::Config& config);

/// Keeps so many of the scenes, evenly spread over all of them.
/// @param count  at most as many as there are
void thinOut(motion::Timeline& timeline, std::int64_t count);

/// Takes the scenes out at which a frame that a writer asks for is not known.
/// @throws Error when none is left
void leaveOutScenesWithout(const std::string& frame, const motion::FrameMotion& frame_motion,
                           motion::Timeline& timeline);

}  // namespace synthetic_dataset
