#include "render/parts/part_groups.h"

#include <map>
#include <utility>

#include "render/pixels/hull_pixels.h"

namespace synthetic_dataset::render {
namespace {

/// Of a part and what is round it by a margin.
std::vector<Eigen::Vector3d> cornersWith(const Part& part, double margin) {
  if (part.hull_V != nullptr) return part.hull_V->cornersWith(margin);
  const Eigen::Vector3d beside = Eigen::Vector3d::Constant(margin);
  return cornersOf(Bounds(part.bounds_V.min() - beside, part.bounds_V.max() + beside));
}

}  // namespace

std::vector<std::vector<Eigen::Vector3d>> hullsOfGroups(
    const std::vector<Part>& parts, const std::vector<Pose>& X_WL, double margin,
    const std::function<bool(const Part&)>& is_chosen) {
  // By object or, of others, by link.
  std::map<std::pair<bool, std::size_t>, std::vector<Eigen::Vector3d>> groups;
  for (const Part& part : parts) {
    if (part.bounds_V.isEmpty() || !is_chosen(part)) continue;
    const bool is_object = part.identifier > 0;
    auto& points = groups[{is_object, is_object ? part.identifier : part.link}];
    const Pose X_WV = X_WL[part.link] * part.X_LV;
    for (const Eigen::Vector3d& corner : cornersWith(part, margin)) {
      points.push_back(X_WV * corner);
    }
  }
  std::vector<std::vector<Eigen::Vector3d>> result;
  result.reserve(groups.size());
  for (auto& group : groups) result.push_back(std::move(group.second));
  return result;
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
