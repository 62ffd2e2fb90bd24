#pragma once

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// Reads a world: its scene, models, lights and cameras. If the world was saved by Gazebo, its
/// <state> says where models, links and lights are.
/// @param world  a `<world>`, or the `<sdf>` of a file without one: its model or light is the world
[[nodiscard]] Description readWorld(const Element& world, SdfReading& reading);

}  // namespace synthetic_dataset::world
