#pragma once

#include <optional>

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// @param collision  its pose is read by the caller, who knows the frames
/// @param scale  how much larger than the file says, by axis
/// @param location  the collision's
/// @return nothing where there is nothing to collide with, and in a survey
[[nodiscard]] std::optional<Collision> readCollision(const Element& collision,
                                                     const Eigen::Vector3d& scale,
                                                     const SourceLocation& location,
                                                     SdfReading& reading);

/// Notes each collision of a moving link whose shape the simulation makes convex.
void noteHulls(const Element& link, const SourceLocation& location, SdfReading& reading);

}  // namespace synthetic_dataset::world
