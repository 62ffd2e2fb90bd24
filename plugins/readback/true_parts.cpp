#include "plugins/readback/true_parts.h"

#include <utility>

#include <opencv2/core.hpp>

namespace synthetic_dataset::formats {

Box TruePart::box() const {
  const cv::Rect pixels = mask.bounds();
  return {pixels.x - 0.5, pixels.y - 0.5, pixels.x + pixels.width - 0.5,
          pixels.y + pixels.height - 0.5};
}

std::vector<TruePart> trueParts(const Scene& scene, const SceneObject& object,
                                const DatasetInfo& dataset) {
  std::vector<TruePart> parts;
  double number = 0.0;
  for (const std::string& name :
       dataset.objects.at(static_cast<std::size_t>(object.instance - 1)).part_names) {
    cv::Mat pixels = scene.part_map() == ++number;
    pixels.setTo(0, ~object.visible_mask().whole());
    Mask mask(pixels);
    if (!mask.empty()) parts.push_back({name, std::move(mask)});
  }
  return parts;
}

cv::Mat trueWorld(const Scene& scene) {
  cv::Mat world(scene.camera.height(), scene.camera.width(), CV_8UC1, cv::Scalar(255));
  for (const SceneObject& object : scene.objects) {
    world.setTo(0, object.visible_mask().whole());
  }
  return world;
}

cv::Mat trueWorldClass(const Scene& scene, std::size_t number) {
  cv::Mat pixels = trueWorld(scene);
  pixels.setTo(0, scene.world_map() != static_cast<double>(number));
  return pixels;
}

}  // namespace synthetic_dataset::formats
