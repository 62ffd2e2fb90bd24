#pragma once

#include <string>
#include <vector>

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// Reads the camera of a sensor, or all cameras of a `multicamera`.
/// @param sensor  a `<sensor>`
/// @param name  scoped: "model::link::sensor"; each camera of a `multicamera` has its own name
///     appended
/// @param X_LS  of the sensor in its link
/// @param location  the sensor's
/// @return none for sensors that are not cameras; cameras whose lens is not supported or whose
///     numbers are invalid are left out, with a note
[[nodiscard]] std::vector<CameraSensor> readCameras(const Element& sensor, const std::string& name,
                                                    const Pose& X_WL, const Pose& X_LS,
                                                    const SourceLocation& location,
                                                    SdfReading& reading);

}  // namespace synthetic_dataset::world
