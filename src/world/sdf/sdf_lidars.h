#pragma once

#include <optional>
#include <string>

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// Reads the lidar of a sensor (`ray`, `gpu_ray`, `lidar`, `gpu_lidar`).
/// @param sensor  a `<sensor>`
/// @param name  scoped: "model::link::sensor"
/// @param X_LS  of the sensor in its link
/// @param location  the sensor's
/// @return nothing for sensors that are not lidars, and for lidars whose numbers are invalid, with
///     a note
[[nodiscard]] std::optional<LidarSensor> readLidar(const Element& sensor, const std::string& name,
                                                   const Pose& X_WL, const Pose& X_LS,
                                                   const SourceLocation& location,
                                                   SdfReading& reading);

}  // namespace synthetic_dataset::world
