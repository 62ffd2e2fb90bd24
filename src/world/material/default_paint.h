#pragma once

#include "world/description.h"

namespace synthetic_dataset::world {

/// Gives all surfaces of a model that lack a material the default one of the simulator: white in
/// Gazebo Classic (OGRE's "BaseWhite"), grey in gz-sim (as in its SceneManager).
void paintDefaults(Simulator simulator, Model& model);

}  // namespace synthetic_dataset::world
