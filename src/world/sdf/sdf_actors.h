#pragma once

#include <string>

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// An `<actor>` as a model that stands: its skin in the first pose of the animation that its
/// trajectory begins with, at the trajectory's first waypoint, as Gazebo shows it at time 0.
/// Without a trajectory it is where its own pose is.
/// @param actor  an `<actor>`
/// @param X_WA  its own pose
/// @param location  the actor's
[[nodiscard]] Model readActor(const Element& actor, const std::string& name, const Pose& X_WA,
                              const SourceLocation& location, SdfReading& reading);

}  // namespace synthetic_dataset::world
