#pragma once

#include <vector>

#include "base/diagnostics.h"
#include "motion/frame_source.h"
#include "scene/camera_rig.h"

namespace synthetic_dataset::scene {

/// Settles where the second cameras of rectified stereo pairs are, of which P[3] or P[7] is not 0:
/// - one that has the frame (or the pose) of its pair's first camera is beside it as P says, and
///   turned as the first one is: the first one's rectification leads from there to the rows that
///   they share, the second one's own leads from the frame that it has by itself;
/// - one that has a frame of its own, about a baseline away from the first one's, is there.
/// `CameraRig::stereo_frame` decides where it is not kAuto.
/// @param diagnostics  gets a warning of each camera of which nothing says whose frame it has
void placeStereoPairs(std::vector<CameraRig>& cameras, const motion::FrameSource& frames,
                      base::Diagnostics& diagnostics);

/// Notes where pictures' frames are that calibrations turn or move.
void notePictureFrames(const std::vector<CameraRig>& cameras, base::Diagnostics& diagnostics);

}  // namespace synthetic_dataset::scene
