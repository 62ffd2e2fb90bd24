#pragma once

#include <cstdint>
#include <vector>

#include "base/diagnostics.h"
#include "scene/object_options.h"
#include "world/world.h"

namespace synthetic_dataset::scene {

/// The class number of each link, from 1 in the order of the classes; 0 for links without a class.
/// @param links  of the world
/// @param diagnostics  receives an error if several classes match a link, and warnings of patterns
///     that match no link
[[nodiscard]] std::vector<std::uint16_t> worldClassNumbers(
    const WorldClasses& classes, const std::vector<world::LinkInstance>& links,
    base::Diagnostics& diagnostics);

/// For each link, the number of the part of its object that it belongs to, from 1 in the order of
/// ObjectOptions::parts; 0 if it belongs to none.
/// @param diagnostics  receives an error if several parts match a link, and one for each pattern
///     that matches no link of its object
[[nodiscard]] std::vector<std::uint16_t> partNumbers(const std::vector<ObjectOptions>& objects,
                                                     const std::vector<world::LinkInstance>& links,
                                                     base::Diagnostics& diagnostics);

}  // namespace synthetic_dataset::scene
