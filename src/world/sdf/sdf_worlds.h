#pragma once

#include <sdf/World.hh>

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// Reads a world: its scene, models, lights and cameras. Where a world was saved by Gazebo, its
/// <state> says where models and lights are.
/// @param place  the file's
void readWorld(const sdf::World& world, const Place& place, SdfReading& reading,
               Description& description);

}  // namespace synthetic_dataset::world
