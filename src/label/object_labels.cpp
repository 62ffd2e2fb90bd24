#include "label/object_labels.h"

#include <cstddef>
#include <vector>

namespace synthetic_dataset::label {

SceneObject labelObject(const ObjectShape& shape, const std::optional<Pose>& X_GO, const Pose& X_GC,
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
  object.X_CO.reset();
  object.keypoints.resize(shape.keypoints_O.size());
  object.dropped = !X_GO;
  if (!X_GO) return object;
  const Pose X_CO = X_GC.inverse() * *X_GO;
  object.X_CO = X_CO;
  for (std::size_t i = 0; i < shape.keypoints_O.size(); ++i) {
    const Eigen::Vector3d p_C = X_CO * shape.keypoints_O[i];
    object.keypoints[i].pixel = camera.project(p_C);
    object.keypoints[i].depth = p_C.z();
  }
  std::vector<Eigen::Vector3d> shape_C;
  for (const Eigen::Vector3d& p_O : shape.bounding_shape_O) shape_C.push_back(X_CO * p_O);
  object.loose_box = camera.projectedBounds(shape_C);
  return object;
}

}  // namespace synthetic_dataset::label
