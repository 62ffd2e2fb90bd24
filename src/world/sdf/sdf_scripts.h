#pragma once

#include <optional>

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// The material that a <material>'s <script> names, of a script or of those that Gazebo ships.
/// @return nothing where there is no <script>, or its material is not to be had (reported)
[[nodiscard]] std::optional<Material> readSdfScript(const Element& material,
                                                    const SourceLocation& location,
                                                    SdfReading& reading);

}  // namespace synthetic_dataset::world
