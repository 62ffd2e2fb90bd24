#pragma once

#include <optional>
#include <string>

#include <sdf/Sensor.hh>

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// @param name  scoped: "model::link::sensor"
/// @return nothing for sensors that are no cameras, and for cameras whose lens is not drawn, which
///     a note says
[[nodiscard]] std::optional<CameraSensor> readCamera(const sdf::Sensor& sensor,
                                                     const std::string& name, const Pose& X_WL,
                                                     const Place& place, SdfReading& reading);

}  // namespace synthetic_dataset::world
