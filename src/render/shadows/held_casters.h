#pragma once

#include <vector>

#include "render/parts/draw_list.h"
#include "render/shadows/shadow_projection.h"

namespace synthetic_dataset::render {

/// Where links cast shadows at some times that follow one another closely: each stays where it is
/// in the middle of those times between which it moves by less than a texel of any map, that is, at
/// most by half a texel from where it is. So it need not be cast anew for each time.
/// @param X_WL  of each of the times, where the links are
[[nodiscard]] std::vector<std::vector<Pose>> heldForShadows(
    const std::vector<Part>& parts, const std::vector<const std::vector<Pose>*>& X_WL,
    const std::vector<ShadowProjection>& shadows);

}  // namespace synthetic_dataset::render
