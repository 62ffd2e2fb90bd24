#pragma once

#include <vector>

#include "render/parts/draw_list.h"
#include "render/shadows/shadow_projection.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::render {

/// X_WL of all links, for each shadow: where they cast it.
using CasterPoses = std::vector<std::vector<Pose>>;

/// Where links cast shadows at some times that follow one another closely: in each map, a link
/// stays where it is in the middle of several times as long as it is less than some texels away
/// from there; less than half of them where it moves steadily. So it need not be cast anew for each
/// time.
/// @param X_WL  of each of the times, where the links are
/// @param texels  of the map
/// @return of each of the times
[[nodiscard]] std::vector<CasterPoses> heldForShadows(
    const std::vector<DrawItem>& items, const std::vector<const std::vector<Pose>*>& X_WL,
    const std::vector<ShadowProjection>& shadows, double texels);

}  // namespace synthetic_dataset::render
