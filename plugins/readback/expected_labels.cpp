#include "plugins/readback/expected_labels.h"

namespace synthetic_dataset::formats {

std::optional<Box> MeasuredScene::box(const MeasuredObject& object, BoxChoice choice) const {
  const std::optional<Box>& box = choice == BoxChoice::kLoose        ? object.loose_box
                                  : choice == BoxChoice::kSilhouette ? object.silhouette_box
                                                                     : object.visible_box;
  return box ? intersection(*box, image()) : std::nullopt;
}

std::optional<Box> MeasuredScene::wholeSilhouette(const MeasuredObject& object) const {
  const std::optional<Box>& box = object.silhouette_box;
  const Box edges = image();
  const bool is_inside = box && box->left >= edges.left && box->top >= edges.top &&
                         box->right <= edges.right && box->bottom <= edges.bottom;
  return is_inside && has_exact_masks ? box : std::nullopt;
}

void ExpectedLabel::setVisibleMask(const MeasuredScene& scene, const MeasuredObject& of) {
  mask_bounds = of.visible_box;
  if (scene.has_exact_masks && !of.is_subtracted) mask_pixels = of.visible_pixels;
}

}  // namespace synthetic_dataset::formats
