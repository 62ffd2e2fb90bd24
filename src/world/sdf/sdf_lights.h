#pragma once

#include <string>

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// @param light  a `<light>`
/// @param name  scoped: "model::link::light"
/// @param location  the light's
[[nodiscard]] Light readLight(const Element& light, const std::string& name, const Pose& X_WL,
                              const SourceLocation& location, SdfReading& reading);

}  // namespace synthetic_dataset::world
