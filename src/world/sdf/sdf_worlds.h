#pragma once

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// Reads a world: its scene, models, lights and cameras. Where a world was saved by Gazebo, its
/// <state> says where models, links and lights are.
/// @param world  a `<world>`
[[nodiscard]] Description readWorld(const Element& world, SdfReading& reading);

/// Reads a file without a world as a world with its model or light alone.
/// @param root  `<sdf>`, with neither more nor less than one of them being read
[[nodiscard]] Description readLoneModel(const Element& root, SdfReading& reading);

}  // namespace synthetic_dataset::world
