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

/// The times at which scenes are made: those of the timeline at which the poses of all sensors, and
/// of all objects that may not be absent, are known throughout each picture's exposure and each
/// lidar's sweep. How much of the recording is lost to this, and which frame is responsible, is
/// reported in the timeline's diagnostics.
/// @param stamps  the times of recorded pictures or clouds, which replace regular ones
/// @throws ErrorList if there is none, saying why
[[nodiscard]] motion::Timeline planScenes(
    const motion::FrameSource& frames, const config::Config& config,
    const std::vector<scene::CameraRig>& cameras, const std::vector<lidar::LidarRig>& lidars,
    const std::vector<std::vector<scene::DrivenLinks>>& driven_links,
    std::optional<std::vector<Stamp>> stamps = std::nullopt);

/// Marks objects that may be absent as absent where their poses would be interpolated across a gap
/// in the recording.
void markAbsentInGaps(const config::Config& config, motion::PlacedFrames& frames);

/// The shortest possible time from one scene to the next.
[[nodiscard]] Duration shortestPeriod(const config::Config& config);

/// Keeps this many scenes: spread evenly over a recording, otherwise the first ones.
/// @param count  at most as many as there are
void thinOut(motion::Timeline& timeline, std::int64_t count);

/// Removes scenes at which a frame requested by a writer is unknown.
/// @throws Error if none is left
void leaveOutScenesWithout(const std::string& frame, const motion::FrameSource& frames,
                           motion::Timeline& timeline);

}  // namespace synthetic_dataset::run
