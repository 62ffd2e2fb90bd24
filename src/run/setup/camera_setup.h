#pragma once

#include <optional>
#include <vector>

#include "run/setup/motion_setup.h"
#include "world/description.h"

/// The cameras of a motion.
namespace synthetic_dataset::run {

/// Makes the cameras, after frames, world and objects. Notes errors; what has one is not there.
/// @param sensors  of the world; none: it cannot be read
void setUpCameras(MotionSetup& setup,
                  const std::optional<std::vector<world::CameraSensor>>& sensors);

/// Has no scene made while an object is not known on which a camera stands or at which one looks.
void needWhatCamerasNeed(MotionSetup& setup);

}  // namespace synthetic_dataset::run
