#pragma once

#include "world/description.h"
#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// Reads a robot: all its links, those without inertia or visuals too, each at its place with every
/// joint at 0 (a joint that mimics another at its offset). The model's frame is its root link's.
/// What Gazebo adds to a link (`<gazebo reference="link">`: its material, its sensors, no gravity)
/// counts as Gazebo takes it. As with SDF, what cannot be understood costs that alone, with a note;
/// links that are no tree are an error in the findings of `outer`.
[[nodiscard]] UrdfModel readUrdfModel(const SdfFile& file, SdfReading& outer);

}  // namespace synthetic_dataset::world
