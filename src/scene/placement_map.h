#pragma once

#include "base/diagnostics.h"
#include "randomize/placement/occupancy_map.h"
#include "scene/scene_options.h"

namespace synthetic_dataset::scene {

/// Reads the map on whose free cells objects are placed: from a file, or from a topic in the bags
/// or of a running system.
/// @param config  of a motion that names a map
/// @param diagnostics  receives what is odd about a map that can still be used
/// @throws Error, or ErrorList, naming the parameter and what is wrong
[[nodiscard]] randomize::OccupancyMap readPlacementMap(const SceneOptions& config,
                                                       base::Diagnostics& diagnostics);

}  // namespace synthetic_dataset::scene
