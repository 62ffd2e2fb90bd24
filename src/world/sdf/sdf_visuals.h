#pragma once

#include <optional>

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// @param visual  its pose is read by the caller, who knows the frames
/// @param scale  how much larger than the file says, by axis
/// @param place  the visual's
/// @return nothing where there is nothing to be seen, and in a survey
[[nodiscard]] std::optional<Visual> readVisual(const Element& visual, const Eigen::Vector3d& scale,
                                               const Place& place, SdfReading& reading);

}  // namespace synthetic_dataset::world
