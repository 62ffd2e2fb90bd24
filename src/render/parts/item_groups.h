#pragma once

#include <functional>
#include <vector>

#include <opencv2/core/types.hpp>

#include "render/parts/draw_list.h"
#include "render/view.h"

namespace synthetic_dataset::render {

/// Points in the world whose convex hulls hold items that belong together: of objects all that is
/// theirs, else one link.
/// @param margin  [m] around the items that the hulls hold as well
/// @param is_chosen  says which items count
[[nodiscard]] std::vector<std::vector<Eigen::Vector3d>> hullsOfGroups(
    const std::vector<DrawItem>& items, const std::vector<Pose>& X_WL, double margin,
    const std::function<bool(const DrawItem&)>& is_chosen);

/// Where an item may be seen: a rectangle of pixels, maybe larger than need be; empty for none.
[[nodiscard]] cv::Rect regionOf(const DrawItem& item, const View& view, const Pose& X_WL);

/// Where some items may be seen: rectangles of pixels, which may overlap, some larger than need be.
[[nodiscard]] std::vector<cv::Rect> regionsOf(
    const std::vector<DrawItem>& items, const View& view, const std::vector<Pose>& X_WL,
    const std::function<bool(const DrawItem&)>& is_chosen);

}  // namespace synthetic_dataset::render
