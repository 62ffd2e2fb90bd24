#pragma once

#include <optional>

#include <sdf/Collision.hh>
#include <sdf/Link.hh>

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// @param place  the link's
/// @return nothing where there is nothing to collide with
[[nodiscard]] std::optional<Collision> readCollision(const sdf::Collision& collision,
                                                     const Place& place, SdfReading& reading);

/// Notes which collisions of a model that moves are simplified to their convex hulls.
void noteHulls(const sdf::Link& link, const Place& place, SdfReading& reading);

}  // namespace synthetic_dataset::world
