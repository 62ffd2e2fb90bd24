#pragma once

#include <optional>

#include <sdf/Material.hh>

#include "world/sdf_reading.h"

namespace synthetic_dataset::world {

/// What stands in for a material script that is not read, for the note about it.
enum class MaterialFallback { kDiffuseColour, kMeshMaterial };

/// The material that an SDF file gives a visual. As in Gazebo, one with any colour or a PBR
/// workflow takes the place of the mesh's own altogether.
/// @return nothing where the file leaves the choice to the mesh
[[nodiscard]] std::optional<Material> readSdfMaterial(const sdf::Material& material,
                                                      MaterialFallback fallback, const Place& place,
                                                      SdfReading& reading);

}  // namespace synthetic_dataset::world
