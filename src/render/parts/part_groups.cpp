#include "render/parts/part_groups.h"

#include <map>
#include <utility>

#include "render/pixels/hull_pixels.h"

namespace synthetic_dataset::render {
namespace {

/// Beyond so many parts, one box around all of them has to do: what is made of hulls takes longer
/// with their corners.
constexpr std::size_t kMostHulls = 4;

Bounds grown(const Bounds& bounds, double margin) {
  const Eigen::Vector3d beside = Eigen::Vector3d::Constant(margin);
  return {bounds.min() - beside, bounds.max() + beside};
}

/// Of parts and what is around them by a margin.
std::vector<Eigen::Vector3d> cornersWith(const std::vector<const Part*>& parts,
                                         const std::vector<Pose>& X_WL, double margin) {
  if (parts.size() > kMostHulls) {
    Bounds bounds;
    for (const Part* part : parts) extend(bounds, *part, X_WL[part->link]);
    return cornersOf(grown(bounds, margin));
  }
  std::vector<Eigen::Vector3d> corners;
  for (const Part* part : parts) {
    const Pose X_WV = X_WL[part->link] * part->X_LV;
    const std::vector<Eigen::Vector3d> of_part = part->hull_V != nullptr
                                                     ? part->hull_V->cornersWith(margin)
                                                     : cornersOf(grown(part->bounds_V, margin));
    for (const Eigen::Vector3d& corner : of_part) corners.push_back(X_WV * corner);
  }
  return corners;
}

}  // namespace

std::vector<std::vector<Eigen::Vector3d>> hullsOfGroups(
    const std::vector<Part>& parts, const std::vector<Pose>& X_WL, double margin,
    const std::function<bool(const Part&)>& is_chosen) {
  // By object or, of others, by link.
  std::map<std::pair<bool, std::size_t>, std::vector<const Part*>> groups;
  for (const Part& part : parts) {
    if (part.bounds_V.isEmpty() || !is_chosen(part)) continue;
    const bool is_object = part.identifier > 0;
    groups[{is_object, is_object ? part.identifier : part.link}].push_back(&part);
  }
  std::vector<std::vector<Eigen::Vector3d>> hulls;
  hulls.reserve(groups.size());
  for (const auto& group : groups) hulls.push_back(cornersWith(group.second, X_WL, margin));
  return hulls;
}

cv::Rect regionOf(const Part& part, const View& view, const Pose& X_WL) {
  if (part.bounds_V.isEmpty()) return {};
  std::vector<Eigen::Vector3d> corners = cornersOf(part.bounds_V);
  const Pose X_WV = X_WL * part.X_LV;
  for (Eigen::Vector3d& corner : corners) corner = X_WV * corner;
  return pixelsOfHull(corners, view);
}

std::vector<cv::Rect> regionsOf(const std::vector<Part>& parts, const View& view,
                                const std::vector<Pose>& X_WL,
                                const std::function<bool(const Part&)>& is_chosen) {
  std::vector<cv::Rect> regions;
  for (const auto& hull : hullsOfGroups(parts, X_WL, 0.0, is_chosen)) {
    const cv::Rect pixels = pixelsOfHull(hull, view);
    if (!pixels.empty()) regions.push_back(pixels);
  }
  return regions;
}

}  // namespace synthetic_dataset::render
