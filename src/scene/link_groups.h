#pragma once

#include <cstdint>
#include <vector>

#include "base/diagnostics.h"
#include "scene/object_options.h"
#include "world/world.h"

namespace synthetic_dataset::scene {

/// The number of each link's class, from 1 in the order of the classes; 0: it has none.
/// @param links  of the world
/// @param diagnostics  takes an error where several classes want a link, and warnings of patterns
/// that no
///     link fits
[[nodiscard]] std::vector<std::uint16_t> worldClassNumbers(
    const WorldClasses& classes, const std::vector<world::LinkInstance>& links,
    base::Diagnostics& diagnostics);

/// The number of the part of its object that each link belongs to, from 1 in the order of
/// ObjectOptions::parts; 0: it is of none.
/// @param diagnostics  takes an error where several parts want a link, and one for each pattern
/// that no
///     link of its object fits
[[nodiscard]] std::vector<std::uint16_t> partNumbers(const std::vector<ObjectOptions>& objects,
                                                     const std::vector<world::LinkInstance>& links,
                                                     base::Diagnostics& diagnostics);

}  // namespace synthetic_dataset::scene
