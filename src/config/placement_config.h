#pragma once

#include "randomize/placement/placement_options.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::config {

/// Reads a group's `volume: {min: [x, y, z], max: [x, y, z]}`, without which there is an error.
[[nodiscard]] randomize::Volume readVolume(Parameters group);

/// Reads the group `placement`. What is wrong is noted there, with a harmless value in its place.
[[nodiscard]] randomize::PlacementOptions readPlacement(Parameters root);

}  // namespace synthetic_dataset::config
