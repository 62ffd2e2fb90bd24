#pragma once

#include <optional>
#include <vector>

#include "plugins/shared/json.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// The data of an object's model that PVNet uses, in the object's frame [m].
struct PvNetModel {
  double diameter = 0.0;
  std::vector<Eigen::Vector3d> corners;  ///< of the box around it
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> farthest_points;  ///< eight of its vertices

  /// Returns nothing for a model without vertices.
  [[nodiscard]] static std::optional<PvNetModel> of(const ObjectModel& model);

  /// Whether all its points project onto the camera's image plane, in or outside the image.
  [[nodiscard]] bool projectsOntoImagePlane(const CameraModel& camera, const Pose& X_CO) const;

  /// The members of an annotation that list these points and their pixels. The model must be in
  /// front of the camera.
  [[nodiscard]] Json annotation(const CameraModel& camera, const Pose& X_CO) const;
};

/// Picks `count` vertices, each the farthest from the previous ones and from the centre of the
/// bounding box: clean-pvnet's sample_farthest_points_init_center
/// (lib/csrc/fps/src/farthest_point_sampling.cpp), in single precision as in the original, so that
/// symmetric models get the same points. Ties go to the first vertex; when no vertices are left,
/// repeats the very first one.
[[nodiscard]] std::vector<Eigen::Vector3d> farthestPoints(const ObjectModel& model,
                                                          std::size_t count);

}  // namespace synthetic_dataset
