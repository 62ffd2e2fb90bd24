#include "plugins/shared/seen_parts.h"

#include <cstddef>

#include <opencv2/core.hpp>

namespace synthetic_dataset {

Box SeenPart::box() const { return boxAround(mask.bounds()); }

std::vector<SeenPart> seenParts(const Scene& scene, const SceneObject& object,
                                const ObjectInfo& info) {
  std::vector<SeenPart> parts;
  const Mask& visible = object.visible_mask();
  if (visible.empty()) return parts;
  const cv::Rect bounds = visible.bounds();
  for (std::size_t i = 0; i < info.part_names.size(); ++i) {
    const cv::Mat pixels =
        (scene.part_map()(bounds) == static_cast<double>(i + 1)) & visible.pixels();
    if (cv::countNonZero(pixels) == 0) continue;
    parts.push_back({info.part_names[i], Mask(pixels, bounds.tl(), visible.imageSize())});
  }
  return parts;
}

}  // namespace synthetic_dataset
