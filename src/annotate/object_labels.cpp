#include "annotate/object_labels.h"

namespace synthetic_dataset::annotate {

SceneObject labelObject(const ObjectShape& shape, const Pose& X_GO, const Pose& X_GC,
                        const CameraModel& camera) {
  SceneObject object;
  object.name = shape.name;
  object.class_name = shape.class_name;
  object.id = shape.id;
  object.keypoints_O = shape.keypoints_O;
  object.bounding_shape_O = shape.bounding_shape_O;
  object.X_GO = X_GO;
  object.X_CO = X_GC.inverse() * X_GO;
  std::vector<Eigen::Vector3d> shape_C;
  for (const Eigen::Vector3d& p_O : shape.bounding_shape_O) shape_C.push_back(object.X_CO * p_O);
  object.loose_box = camera.projectedBounds(shape_C);
  object.in_view =
      object.loose_box && intersection(*object.loose_box, camera.imageBounds()).has_value();
  return object;
}

}  // namespace synthetic_dataset::annotate
