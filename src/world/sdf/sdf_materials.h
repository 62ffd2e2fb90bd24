#pragma once

#include <optional>

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// The material that an SDF file gives a visual. As in Gazebo, one with a script, any colour or a
/// PBR workflow takes the place of the mesh's own altogether, and colours take the place of the
/// script's.
/// @param location  the visual's
/// @return nothing where the file leaves the choice to the mesh; in a survey, one without pictures
[[nodiscard]] std::optional<Material> readSdfMaterial(const Element& visual,
                                                      const SourceLocation& location,
                                                      SdfReading& reading);

}  // namespace synthetic_dataset::world
