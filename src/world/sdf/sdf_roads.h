#pragma once

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// A `<road>`: a strip of the given width along its points, as Gazebo Classic draws it (its
/// rendering::Road2d), as a static model of the road's name.
/// @param location  the road's
[[nodiscard]] Model readRoad(const Element& road, const SourceLocation& location,
                             SdfReading& reading);

}  // namespace synthetic_dataset::world
