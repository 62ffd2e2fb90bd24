#pragma once

#include "world/description.h"
#include "world/urdf/urdf_geometry.h"

namespace synthetic_dataset::world {

/// Reads a robot: all its links, those without inertia or visuals too, each at its place with every
/// joint at 0 (a joint that mimics another at its offset). The model's frame is its root link's.
/// What is wrong is reported in the reading's findings.
[[nodiscard]] Model readUrdfModel(UrdfReading& reading);

}  // namespace synthetic_dataset::world
