#pragma once

#include <optional>

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// @param collision  its pose is read by the caller, who knows the frames
/// @param scale  factors on the sizes in the file, by axis
/// @param location  the collision's
/// @return nothing if there is nothing to collide with, and in a survey
[[nodiscard]] std::optional<Collision> readCollision(const Element& collision,
                                                     const Eigen::Vector3d& scale,
                                                     const SourceLocation& location,
                                                     SdfReading& reading);

/// Adds a note for each polyline, heightmap or image that is a collision of a moving link: the
/// simulation uses its convex hull.
void noteHulls(const Element& link, const SourceLocation& location, SdfReading& reading);

}  // namespace synthetic_dataset::world
