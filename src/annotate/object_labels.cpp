#include "annotate/object_labels.h"

namespace synthetic_dataset::annotate {

namespace {

Keypoint keypointAt(const Eigen::Vector3d& p_C, const CameraModel& camera) {
  Keypoint keypoint{camera.project(p_C), p_C.z(), KeypointState::kOutside};
  if (!keypoint.pixel) return keypoint;
  const Box image = camera.imageBounds();
  const Eigen::Vector2d& pixel = *keypoint.pixel;
  const bool is_inside = pixel.x() >= image.left && pixel.x() < image.right &&
                         pixel.y() >= image.top && pixel.y() < image.bottom;
  if (is_inside) keypoint.state = KeypointState::kVisible;
  return keypoint;
}

}  // namespace

SceneObject labelObject(const ObjectShape& shape, const Pose& X_GO, const Pose& X_GC,
                        const CameraModel& camera) {
  SceneObject object;
  object.name = shape.name;
  object.class_text = shape.class_text;
  object.class_name = shape.class_name;
  object.id = shape.id;
  object.class_id = shape.class_id;
  object.instance = shape.instance;
  object.keypoints_O = shape.keypoints_O;
  object.bounding_shape_O = shape.bounding_shape_O;
  object.cuboid_O = shape.cuboid_O;
  object.X_GO = X_GO;
  object.X_CO = X_GC.inverse() * X_GO;
  for (const Eigen::Vector3d& p_O : shape.keypoints_O) {
    object.keypoints.push_back(keypointAt(object.X_CO * p_O, camera));
  }
  std::vector<Eigen::Vector3d> shape_C;
  for (const Eigen::Vector3d& p_O : shape.bounding_shape_O) shape_C.push_back(object.X_CO * p_O);
  object.loose_box = camera.projectedBounds(shape_C);
  object.in_view =
      object.loose_box && intersection(*object.loose_box, camera.imageBounds()).has_value();
  return object;
}

}  // namespace synthetic_dataset::annotate
