#pragma once

#include <vector>

#include "base/diagnostics.h"
#include "motion/frame_source.h"
#include "scene/camera_rig.h"

namespace synthetic_dataset::scene {

/// Decides the poses of the second cameras of rectified stereo pairs, those whose P[3] or P[7] is
/// not 0:
/// - one that has the frame (or the pose) of its pair's first camera is placed next to it as P
///   says, and rotated like the first: the first camera's rectification leads from that frame to
///   the rows that they share, whereas the second camera's leads from the frame that it has by
///   itself;
/// - one that has a frame of its own, about a baseline away from the first one's, stays there.
/// `CameraRig::stereo_frame` decides if it is not kAuto.
/// @param diagnostics  receives a warning for each camera for which it is unclear whose frame it
///     has
void placeStereoPairs(std::vector<CameraRig>& cameras, const motion::FrameSource& frames,
                      base::Diagnostics& diagnostics);

/// Notes the poses of picture frames that calibrations rotate or move.
void notePictureFrames(const std::vector<CameraRig>& cameras, base::Diagnostics& diagnostics);

}  // namespace synthetic_dataset::scene
