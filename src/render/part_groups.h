#pragma once

#include <functional>
#include <vector>

#include "render/draw_list.h"

namespace synthetic_dataset::render {

/// Round parts that belong together, in the world: of objects all that is theirs, else one link.
/// @param is_chosen  says which parts count
[[nodiscard]] std::vector<Bounds> boundsOfGroups(const std::vector<Part>& parts,
                                                 const std::vector<Pose>& X_WL,
                                                 const std::function<bool(const Part&)>& is_chosen);

}  // namespace synthetic_dataset::render
