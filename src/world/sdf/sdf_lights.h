#pragma once

#include <string>

#include <sdf/Light.hh>

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// @param name  scoped: "model::link::light"
[[nodiscard]] Light readLight(const sdf::Light& light, const std::string& name, const Pose& X_WL,
                              const Place& place, SdfReading& reading);

}  // namespace synthetic_dataset::world
