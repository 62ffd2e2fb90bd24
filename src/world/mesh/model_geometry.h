#pragma once

#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/pose.h"
#include "world/description.h"

namespace synthetic_dataset::world {

/// The outermost points of a model's visuals, link by link, which determine its extent exactly for
/// any poses of the links.
class ModelGeometry {
 public:
  /// @param links  of the model
  explicit ModelGeometry(const std::vector<const Link*>& links);

  /// Whether nothing of the model can be seen.
  [[nodiscard]] bool isEmpty() const;

  /// The corners of the smallest box around all visuals along the axes of O, sorted by x, then y,
  /// then z.
  /// @param X_OL  of each link
  [[nodiscard]] std::vector<Eigen::Vector3d> box(const std::vector<Pose>& X_OL) const;

 private:
  std::vector<std::vector<Eigen::Vector3d>> points_L_;  ///< of each link
};

}  // namespace synthetic_dataset::world
