#pragma once

#include <vector>

#include "render/parts/draw_list.h"
#include "render/shadows/shadow_projection.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::render {

/// X_WL of all links, for each shadow: the poses in which they cast it.
using CasterPoses = std::vector<std::vector<Pose>>;

/// The poses in which links cast shadows at some times that follow one another closely: in each
/// map, a link is held in its pose at the middle of several times, as long as it is less than
/// `texels` away from there (less than half of that if it moves steadily), so that it need not be
/// cast again for each time.
/// @param X_WL  the links' poses at each of the times
/// @param texels  of the map
/// @return for each of the times
[[nodiscard]] std::vector<CasterPoses> heldForShadows(
    const std::vector<DrawItem>& items, const std::vector<const std::vector<Pose>*>& X_WL,
    const std::vector<ShadowProjection>& shadows, double texels);

}  // namespace synthetic_dataset::render
