#pragma once

#include "world/material/material_source.h"
#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// Puts the numbers and maps of a material's PBR workflow, the metal one where there are both, in
/// the place of what `to` has.
/// @param material  a `<material>`
/// @param location  the visual's
/// @return whether the material has a workflow
bool readPbr(const Element& material, const SourceLocation& location, SdfReading& reading,
             MaterialSource& to);

}  // namespace synthetic_dataset::world
