#include "programs/drawing/scene_picture.h"

#include <string>

#include "plugins/readback/cuboid_lines.h"
#include "plugins/readback/label_overlay.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::programs {
namespace {

cv::Point2d imagePoint(const Eigen::Vector2d& pixel) { return {pixel.x(), pixel.y()}; }

/// The label to draw for an object of which the camera sees something.
formats::DrawnLabel labelOf(const Scene& scene, const SceneObject& object) {
  formats::DrawnLabel label;
  label.caption = object.name + ", " + std::to_string(object.pixels.visible()) + " px, " +
                  fixed(object.distance(), 1) + " m";
  label.colour = static_cast<std::size_t>(object.class_id);
  label.mask = object.visible_mask().whole();
  label.box = object.visibleBox();
  label.lines = formats::cuboidLines(object.cuboid_O, *object.X_CO, scene.camera);
  for (const Keypoint& keypoint : object.keypoints) {
    if (!keypoint.pixel) continue;
    const bool is_hidden = keypoint.state.isKnown() && keypoint.state() != KeypointState::kVisible;
    (is_hidden ? label.hidden_keypoints : label.keypoints).push_back(imagePoint(*keypoint.pixel));
  }
  return label;
}

}  // namespace

cv::Mat pictureWithLabels(const Scene& scene) {
  formats::LabelledPicture picture;
  picture.image = scene.image;
  for (const SceneObject& object : scene.objects) {
    if (object.pixels.visible() > 0) picture.labels.push_back(labelOf(scene, object));
  }
  return formats::drawLabels(picture);
}

}  // namespace synthetic_dataset::programs
