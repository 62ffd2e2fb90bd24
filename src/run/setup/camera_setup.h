#pragma once

#include <optional>
#include <vector>

#include "run/setup/motion_setup.h"
#include "world/description.h"

/// The cameras of a motion.
namespace synthetic_dataset::run {

/// Creates the cameras, after frames, world and objects. Notes errors; anything with an error is
/// left out.
/// @param sensors  of the world; nothing if it cannot be read
void setUpCameras(MotionSetup& setup,
                  const std::optional<std::vector<world::CameraSensor>>& sensors);

/// Prevents scenes at times when the pose of an object that carries a camera, or at which a camera
/// looks, is unknown.
void requireObjectsOfCameras(MotionSetup& setup);

}  // namespace synthetic_dataset::run
