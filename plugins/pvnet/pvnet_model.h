#pragma once

#include <optional>
#include <vector>

#include "plugins/shared/json.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// What PVNet knows of an object's model, in the object's frame [m].
struct PvNetModel {
  double diameter = 0.0;
  std::vector<Eigen::Vector3d> corners;  ///< of the box around it
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> farthest_points;  ///< eight of its vertices

  /// Nothing for a model without vertices.
  [[nodiscard]] static std::optional<PvNetModel> of(const ObjectModel& model);

  /// Whether all its points have a place on the camera's image or beside it.
  [[nodiscard]] bool isBefore(const CameraModel& camera, const Pose& X_CO) const;

  /// The members of an annotation that name these points and where they are in the image.
  /// The model is before the camera.
  [[nodiscard]] Json annotation(const CameraModel& camera, const Pose& X_CO) const;
};

/// As many vertices as asked for, each the farthest from those before it and from the centre of the
/// box around all: clean-pvnet's sample_farthest_points_init_center
/// (lib/csrc/fps/src/farthest_point_sampling.cpp), in single precision as there, so that symmetric
/// models have the same points. Of equally far ones, the first; the first of all once there are no
/// more.
[[nodiscard]] std::vector<Eigen::Vector3d> farthestPoints(const ObjectModel& model,
                                                          std::size_t count);

}  // namespace synthetic_dataset
