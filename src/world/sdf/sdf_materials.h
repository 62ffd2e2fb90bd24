#pragma once

#include <optional>

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// The material that an SDF file gives a visual. As in Gazebo, a material with a script, any colour
/// or a PBR workflow replaces the mesh's own entirely, and colours override the script's.
/// @param location  the visual's
/// @return nothing if the file leaves the choice to the mesh; in a survey, a material without
///     pictures
[[nodiscard]] std::optional<Material> readSdfMaterial(const Element& visual,
                                                      const SourceLocation& location,
                                                      SdfReading& reading);

}  // namespace synthetic_dataset::world
