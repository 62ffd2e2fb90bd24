#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "render/view.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::label {

/// Where all was while a picture was taken whose rows are taken one after the other.
struct TakenInRows {
  render::RollingView view;       ///< with the world's links
  render::LinkSelection present;  ///< at all of its moments

  /// Of each object at each of its moments.
  std::vector<std::vector<std::optional<Pose>>> X_GO;
};

/// A point as such a picture has it.
struct PointInRows {
  Eigen::Vector2d pixel;
  Eigen::Vector3d p_C;  ///< in the optical frame of that row's time [m]
};

/// Where a picture whose rows are taken one after the other has points of bodies.
///
/// A point is where the row that it falls on is the row that is taken just then. Above the picture
/// it is where the first row has it, below it where the last row has it. Something that outruns the
/// rows may be there several times: then it is the one that is nearest to the middle row.
class RowFinder {
 public:
  /// @param view  has to outlive this; its links are the bodies
  /// @param bodies  those that are asked for
  RowFinder(const render::RollingView& view, const std::vector<bool>& bodies);

  /// @return nothing for a point that is behind the camera, or that its lens cannot see
  [[nodiscard]] std::optional<PointInRows> find(std::size_t body, const Eigen::Vector3d& p_B) const;

 private:
  [[nodiscard]] std::optional<PointInRows> between(std::size_t body, const Eigen::Vector3d& p_B,
                                                   std::size_t moment, double before,
                                                   double after) const;

  const render::RollingView& view_;
  std::vector<std::vector<Pose>> X_CB_;  ///< of each body at each moment
};

/// Puts the objects' labels that follow from their poses where the picture has them: the places of
/// keypoints, the projected boxes. Poses, and the depths of keypoints, stay those of the middle of
/// the exposure.
/// @return of each object, its keypoints in the optical frame of their rows' times [m]; empty for
///     one that is not in the scene
[[nodiscard]] std::vector<std::vector<Eigen::Vector3d>> labelInRows(const TakenInRows& taken,
                                                                    Scene& scene);

}  // namespace synthetic_dataset::label
