#pragma once

#include <optional>
#include <string>

#include <sdf/Sensor.hh>

#include "world/sdf_loader.h"
#include "world/sdf_reading.h"

namespace synthetic_dataset::world {

/// @param name  scoped: "model::link::sensor"
/// @return nothing for sensors that are no cameras with a pinhole
[[nodiscard]] std::optional<CameraSensor> readCamera(const sdf::Sensor& sensor,
                                                     const std::string& name, const Pose& X_WL,
                                                     const SdfLoadOptions& options,
                                                     const Place& place, SdfReading& reading);

}  // namespace synthetic_dataset::world
