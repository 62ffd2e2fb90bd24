#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core/types.hpp>

#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::render {

/// Which links take part in a pass: one flag a link, in the world's order.
using LinkSelection = std::vector<bool>;

/// Where a lens's view begins, in the frame of a picture that is drawn for it.
struct NearLimit {
  Eigen::Vector3d axis_C = Eigen::Vector3d::Zero();  ///< along which it counts; zero: by distance
  double reach = 0.0;                                ///< [m]
};

/// From where a picture is taken.
struct View {
  CameraModel camera;
  Pose X_WC = Pose::Identity();  ///< of the optical frame

  /// Where the near plane lies before that of the lens that the picture is drawn for.
  std::optional<NearLimit> near_limit = std::nullopt;
};

/// Clip coordinates from points of the optical frame.
///
/// The image's first row is OpenGL's first row (v grows upwards there), so that what is read back
/// needs no turning; front faces are clockwise then. A pixel's centre (u, v) in OpenCV's convention
/// is OpenGL's (u + 0.5, v + 0.5). Depth is reversed (1 at the near plane, 0 at the far one), which
/// with floating-point depth keeps its precision nearly the same at all distances.
[[nodiscard]] Eigen::Matrix4d clipFromCamera(const CameraModel& camera);

/// The poses at the time at which a row of a picture is taken.
struct RollingMoment {
  double row = 0.0;  ///< from the picture's first; may lie between rows, or beside the picture
  Pose X_WC = Pose::Identity();
  std::vector<Pose> X_WL;  ///< of each link
};

/// The view of a picture whose rows are taken at different times (rolling shutter).
struct RollingView {
  CameraModel camera;

  /// At least two, in the order of their rows. Between them poses are interpolated.
  std::vector<RollingMoment> moments;

  /// Rows that share the time of their lights and shadows, as bands of equal height.
  int bands = 1;

  /// The poses when a row is taken. Orientations turn evenly, as tf2 has it. Beyond the first and
  /// the last moment all stands as it does then.
  [[nodiscard]] RollingMoment at(double row) const;

  /// The same for who asks for some links alone: the others are where they are at a moment nearby.
  [[nodiscard]] RollingMoment at(double row, const LinkSelection& links) const;

  /// Where the camera has a link when a row is taken, as at() has it.
  [[nodiscard]] Pose X_CL(std::size_t link, double row) const;

  /// When the middle row is taken.
  [[nodiscard]] RollingMoment middle() const { return at(0.5 * (camera.height() - 1)); }

  /// The picture's rows of one of the bands.
  [[nodiscard]] cv::Rect rowsOf(int band) const;
};

}  // namespace synthetic_dataset::render
