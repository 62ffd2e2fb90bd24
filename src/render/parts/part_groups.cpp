#include "render/parts/part_groups.h"

#include <map>
#include <utility>

#include "render/pixels/hull_pixels.h"

namespace synthetic_dataset::render {

std::vector<Bounds> boundsOfGroups(const std::vector<Part>& parts, const std::vector<Pose>& X_WL,
                                   const std::function<bool(const Part&)>& is_chosen) {
  std::map<std::pair<bool, std::size_t>, Bounds> groups;  // by object or, of others, by link
  for (const Part& part : parts) {
    if (part.bounds_V.isEmpty() || !is_chosen(part)) continue;
    const bool is_object = part.identifier > 0;
    extend(groups[{is_object, is_object ? part.identifier : part.link}], part, X_WL[part.link]);
  }
  std::vector<Bounds> result;
  for (const auto& group : groups) result.push_back(group.second);
  return result;
}

std::vector<cv::Rect> regionsOf(const std::vector<Part>& parts, const View& view,
                                const std::vector<Pose>& X_WL,
                                const std::function<bool(const Part&)>& is_chosen) {
  std::vector<cv::Rect> regions;
  for (const Bounds& group : boundsOfGroups(parts, X_WL, is_chosen)) {
    const cv::Rect pixels = pixelsOfHull(cornersOf(group), view);
    if (!pixels.empty()) regions.push_back(pixels);
  }
  return regions;
}

}  // namespace synthetic_dataset::render
