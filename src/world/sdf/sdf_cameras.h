#pragma once

#include <string>
#include <vector>

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// The camera of a sensor; of a `multicamera`, all that it has.
/// @param sensor  a `<sensor>`
/// @param name  scoped: "model::link::sensor"; each camera of a `multicamera` has its own behind it
/// @param X_LS  of the sensor in its link
/// @param location  the sensor's
/// @return none for sensors that are not cameras; those are left out whose lens is not drawn or
///     whose numbers are none, which a note says
[[nodiscard]] std::vector<CameraSensor> readCameras(const Element& sensor, const std::string& name,
                                                    const Pose& X_WL, const Pose& X_LS,
                                                    const SourceLocation& location,
                                                    SdfReading& reading);

}  // namespace synthetic_dataset::world
