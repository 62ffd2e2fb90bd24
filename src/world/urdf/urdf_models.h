#pragma once

#include "world/description.h"
#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// Reads a robot: all its links, including those without inertia or visuals, placed with every
/// joint at 0 (a joint that mimics another at its offset). The model's frame is that of its root
/// link. What Gazebo adds to a link (`<gazebo reference="link">`: its material, its sensors, no
/// gravity) is applied as in Gazebo. As with SDF, an element that cannot be understood is noted,
/// and affects nothing else; links that do not form a tree are an error in the findings of `outer`.
[[nodiscard]] UrdfModel readUrdfModel(const SdfFile& file, SdfReading& outer);

}  // namespace synthetic_dataset::world
