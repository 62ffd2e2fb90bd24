#pragma once

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// Reads a world's `<scene>`: ambient light, background, sky and fog. What it leaves out is as in
/// Gazebo, whose defaults the description has.
/// @param scene  may be none
/// @param location  the scene's
void readScene(const Element& scene, const SourceLocation& location, SdfReading& reading,
               Description& description);

/// Whether the scene has shadows; without a say there are.
[[nodiscard]] bool hasShadows(const Element& scene, const SourceLocation& location,
                              SdfReading& reading);

}  // namespace synthetic_dataset::world
