#pragma once

#include "world/description.h"

namespace synthetic_dataset::world {

/// Gives all surfaces of a model that have no material that of the simulator: white in Gazebo
/// Classic (OGRE's "BaseWhite"), grey in gz-sim, as it is in gz-sim's SceneManager.
void paintDefaults(Simulator simulator, Model& model);

}  // namespace synthetic_dataset::world
