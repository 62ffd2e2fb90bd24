#include "render/parts/item_groups.h"

#include <map>
#include <utility>

#include "render/pixels/hull_pixels.h"

namespace synthetic_dataset::render {
namespace {

/// If a group has more items than this, one box around all of them is used: the more corners, the
/// longer hulls take.
constexpr std::size_t kMostHulls = 4;

Bounds withMargin(const Bounds& bounds, double margin) {
  const Eigen::Vector3d beside = Eigen::Vector3d::Constant(margin);
  return {bounds.min() - beside, bounds.max() + beside};
}

/// The corners of items' hulls or bounds, grown by a margin.
std::vector<Eigen::Vector3d> cornersWith(const std::vector<const DrawItem*>& items,
                                         const std::vector<Pose>& X_WL, double margin) {
  if (items.size() > kMostHulls) {
    Bounds bounds;
    for (const DrawItem* item : items) extend(bounds, *item, X_WL[item->link]);
    return cornersOf(withMargin(bounds, margin));
  }
  std::vector<Eigen::Vector3d> corners;
  for (const DrawItem* item : items) {
    const Pose X_WV = X_WL[item->link] * item->X_LV;
    const std::vector<Eigen::Vector3d> of_part =
        item->hull_V != nullptr ? item->hull_V->cornersWith(margin)
                                : cornersOf(withMargin(item->bounds_V, margin));
    for (const Eigen::Vector3d& corner : of_part) corners.push_back(X_WV * corner);
  }
  return corners;
}

}  // namespace

std::vector<std::vector<Eigen::Vector3d>> hullsOfGroups(
    const std::vector<DrawItem>& items, const std::vector<Pose>& X_WL, double margin,
    const std::function<bool(const DrawItem&)>& is_chosen) {
  // By object or, for items that are of none, by link.
  std::map<std::pair<bool, std::size_t>, std::vector<const DrawItem*>> groups;
  for (const DrawItem& item : items) {
    if (item.bounds_V.isEmpty() || !is_chosen(item)) continue;
    const bool is_object = item.identifier > 0;
    groups[{is_object, is_object ? item.identifier : item.link}].push_back(&item);
  }
  std::vector<std::vector<Eigen::Vector3d>> hulls;
  hulls.reserve(groups.size());
  for (const auto& group : groups) hulls.push_back(cornersWith(group.second, X_WL, margin));
  return hulls;
}

cv::Rect regionOf(const DrawItem& item, const View& view, const Pose& X_WL) {
  if (item.bounds_V.isEmpty()) return {};
  std::vector<Eigen::Vector3d> corners = cornersOf(item.bounds_V);
  const Pose X_WV = X_WL * item.X_LV;
  for (Eigen::Vector3d& corner : corners) corner = X_WV * corner;
  return pixelsOfHull(corners, view);
}

std::vector<cv::Rect> regionsOf(const std::vector<DrawItem>& items, const View& view,
                                const std::vector<Pose>& X_WL,
                                const std::function<bool(const DrawItem&)>& is_chosen) {
  std::vector<cv::Rect> regions;
  for (const auto& hull : hullsOfGroups(items, X_WL, 0.0, is_chosen)) {
    const cv::Rect pixels = pixelsOfHull(hull, view);
    if (!pixels.empty()) regions.push_back(pixels);
  }
  return regions;
}

}  // namespace synthetic_dataset::render
