#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "config/config.h"
#include "lidar/lidar_rig.h"
#include "motion/frame_source.h"
#include "motion/placed_frames.h"
#include "scene/articulation.h"
#include "scene/camera_rig.h"

namespace synthetic_dataset::run {

/// The times at which scenes are made: those of the timeline at which all sensors are known, and
/// all objects that may not be absent, over the whole exposure of each picture and the whole sweep
/// of each lidar. What that costs of the recording, and whose it is, is among the timeline's
/// diagnostics.
/// @param stamps  the times of recorded pictures or clouds, which take the place of regular ones
/// @throws ErrorList when there is none, saying why
[[nodiscard]] motion::Timeline planScenes(
    const motion::FrameSource& frames, const config::Config& config,
    const std::vector<scene::CameraRig>& cameras, const std::vector<lidar::LidarRig>& lidars,
    const std::vector<std::vector<scene::DrivenLinks>>& driven_links,
    std::optional<std::vector<Stamp>> stamps = std::nullopt);

/// Makes objects that may be absent so where their poses would be interpolated across a hole.
void forgetInHoles(const config::Config& config, motion::PlacedFrames& frames);

/// The least time that there may be from one scene to the next.
[[nodiscard]] Duration shortestPeriod(const config::Config& config);

/// Keeps this many scenes, evenly spread over a recording, else the first ones.
/// @param count  at most as many as there are
void thinOut(motion::Timeline& timeline, std::int64_t count);

/// Takes the scenes out at which a frame that a writer asks for is not known.
/// @throws Error when none is left
void leaveOutScenesWithout(const std::string& frame, const motion::FrameSource& frames,
                           motion::Timeline& timeline);

}  // namespace synthetic_dataset::run
