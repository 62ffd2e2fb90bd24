#pragma once

#include <functional>
#include <vector>

#include <opencv2/core/types.hpp>

#include "render/parts/draw_list.h"
#include "render/view.h"

namespace synthetic_dataset::render {

/// For each group of items that belong together (all items of an object, otherwise all of a link),
/// points in the world whose convex hull contains the group.
/// @param margin  [m] around the items that the hulls contain as well
/// @param is_chosen  whether an item counts
[[nodiscard]] std::vector<std::vector<Eigen::Vector3d>> hullsOfGroups(
    const std::vector<DrawItem>& items, const std::vector<Pose>& X_WL, double margin,
    const std::function<bool(const DrawItem&)>& is_chosen);

/// The rectangle of pixels in which an item may be seen, possibly too large; empty if there are
/// none.
[[nodiscard]] cv::Rect regionOf(const DrawItem& item, const View& view, const Pose& X_WL);

/// Rectangles of pixels in which some items may be seen; they may overlap, and some may be too
/// large.
[[nodiscard]] std::vector<cv::Rect> regionsOf(
    const std::vector<DrawItem>& items, const View& view, const std::vector<Pose>& X_WL,
    const std::function<bool(const DrawItem&)>& is_chosen);

}  // namespace synthetic_dataset::render
