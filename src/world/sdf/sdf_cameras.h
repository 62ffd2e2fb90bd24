#pragma once

#include <optional>
#include <string>

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// @param sensor  a `<sensor>`
/// @param name  scoped: "model::link::sensor"
/// @param X_LS  of the sensor in its link
/// @param location  the sensor's
/// @return nothing for sensors that are not cameras, and for cameras whose lens is not drawn or
///     whose numbers are none, which a note says
[[nodiscard]] std::optional<CameraSensor> readCamera(const Element& sensor, const std::string& name,
                                                     const Pose& X_WL, const Pose& X_LS,
                                                     const SourceLocation& location,
                                                     SdfReading& reading);

}  // namespace synthetic_dataset::world
