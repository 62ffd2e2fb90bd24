#pragma once

#include <optional>

#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// The file's inertia if it is one that a solid body can have; another is noted.
/// @param location  the link's
[[nodiscard]] std::optional<Inertia> readInertia(const Element& link,
                                                 const SourceLocation& location,
                                                 SdfReading& reading);

}  // namespace synthetic_dataset::world
