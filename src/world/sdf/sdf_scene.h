#pragma once

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// Reads a world's `<scene>`: ambient light, background, sky and fog. What it omits keeps the
/// description's defaults, which are Gazebo's.
/// @param scene  may be none
/// @param location  the scene's
void readScene(const Element& scene, const SourceLocation& location, SdfReading& reading,
               Description& description);

/// Whether the scene has shadows; the default is true.
[[nodiscard]] bool hasShadows(const Element& scene, const SourceLocation& location,
                              SdfReading& reading);

}  // namespace synthetic_dataset::world
