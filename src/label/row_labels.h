#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "render/view.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::label {

/// Where everything was while a picture was taken whose rows are taken one after the other.
struct CapturedRows {
  render::RollingView view;       ///< with the world's links
  render::LinkSelection present;  ///< at all of the view's moments

  /// The pose of each object at each of the view's moments.
  std::vector<std::vector<std::optional<Pose>>> X_GO;
};

/// A point as it appears in such a picture.
struct PointInRows {
  Eigen::Vector2d pixel;
  Eigen::Vector3d p_C;  ///< in the optical frame at that row's time [m]
};

/// Finds where points of bodies appear in a picture whose rows are taken one after the other.
///
/// A point appears where the row that it falls on is the row being taken at that time. Above the
/// picture, its position is that at the time of the first row, below it that at the time of the
/// last row. Something that outruns the rows may appear several times: then the position nearest to
/// the middle row counts.
class RowFinder {
 public:
  /// @param view  has to outlive this; its links are the bodies
  /// @param bodies  which of them are looked up
  RowFinder(const render::RollingView& view, const std::vector<bool>& bodies);

  /// @return nothing for a point that is behind the camera, or that the lens cannot see
  [[nodiscard]] std::optional<PointInRows> find(std::size_t body, const Eigen::Vector3d& p_B) const;

 private:
  [[nodiscard]] std::optional<PointInRows> between(std::size_t body, const Eigen::Vector3d& p_B,
                                                   std::size_t moment, double before,
                                                   double after) const;

  const render::RollingView& view_;
  std::vector<std::vector<Pose>> X_CB_;  ///< of each body at each moment
};

/// Moves the objects' labels that follow from their poses to where they appear in the picture: the
/// positions of keypoints, the projected boxes. Poses, and the depths of keypoints, stay those of
/// the middle of the exposure.
/// @return the keypoints of each object in the optical frame at their rows' times [m]; empty for an
///     object that is not in the scene
[[nodiscard]] std::vector<std::vector<Eigen::Vector3d>> labelInRows(const CapturedRows& taken,
                                                                    Scene& scene);

}  // namespace synthetic_dataset::label
