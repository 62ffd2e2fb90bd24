#pragma once

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// Reads a `<road>`, a strip of the given width along its points, as a static model with the road's
/// name, drawn as by Gazebo Classic (rendering::Road2d).
/// @param location  the road's
[[nodiscard]] Model readRoad(const Element& road, const SourceLocation& location,
                             SdfReading& reading);

}  // namespace synthetic_dataset::world
