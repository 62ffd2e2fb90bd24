#pragma once

#include <optional>

#include <sdf/Collision.hh>

#include "world/sdf_reading.h"

namespace synthetic_dataset::world {

/// @param place  the link's
/// @return nothing where there is nothing to collide with
[[nodiscard]] std::optional<Collision> readCollision(const sdf::Collision& collision,
                                                     const Place& place, SdfReading& reading);

}  // namespace synthetic_dataset::world
