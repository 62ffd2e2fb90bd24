#pragma once

#include "base/diagnostics.h"
#include "randomize/placement/occupancy_map.h"
#include "scene/scene_options.h"

namespace synthetic_dataset::scene {

/// The map on whose free cells objects are placed: of a file, or of a topic in the bags or of a
/// running system.
/// @param config  of a motion that names one
/// @param diagnostics  takes what is odd about a map that can be used
/// @throws Error, or ErrorList, naming the parameter and what is wrong
[[nodiscard]] randomize::OccupancyMap readPlacementMap(const SceneOptions& config,
                                                       base::Diagnostics& diagnostics);

}  // namespace synthetic_dataset::scene
