#pragma once

#include <optional>

#include <sdf/Visual.hh>

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// @param place  the link's
/// @return nothing where there is nothing to be seen
[[nodiscard]] std::optional<Visual> readVisual(const sdf::Visual& visual, const Place& place,
                                               SdfReading& reading);

}  // namespace synthetic_dataset::world
