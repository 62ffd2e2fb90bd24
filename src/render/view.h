#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core/types.hpp>

#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::render {

/// Which links take part in a pass: one flag per link, in the world's order.
using LinkSelection = std::vector<bool>;

/// Where a lens's view begins, in the frame of a picture that is drawn for it.
struct NearLimit {
  Eigen::Vector3d axis_C = Eigen::Vector3d::Zero();  ///< reach is along it; zero: by distance
  double reach = 0.0;                                ///< [m]
};

/// The camera of a picture and where it is.
struct View {
  CameraModel camera;
  Pose X_WC = Pose::Identity();  ///< of the optical frame

  /// The lens's near limit, if this picture is drawn for a lens and its near plane lies in front of
  /// that limit.
  std::optional<NearLimit> near_limit = std::nullopt;
};

/// The matrix that transforms points of the optical frame to clip coordinates.
///
/// The image's first row is OpenGL's first row (where v grows upwards), so that what is read back
/// need not be flipped; front faces are therefore clockwise. A pixel's centre (u, v) in OpenCV's
/// convention is OpenGL's (u + 0.5, v + 0.5). Depth is reversed (1 at the near plane, 0 at the far
/// one), which with floating-point depth keeps its precision nearly the same at all distances.
[[nodiscard]] Eigen::Matrix4d clipFromCamera(const CameraModel& camera);

/// The poses at the time at which a row of a picture is taken.
struct RollingMoment {
  double row = 0.0;  ///< from the picture's first; may lie between rows, or outside the picture
  Pose X_WC = Pose::Identity();
  std::vector<Pose> X_WL;  ///< of each link
};

/// The view of a picture whose rows are taken at different times (rolling shutter).
struct RollingView {
  CameraModel camera;

  /// At least two, in the order of their rows. Between them poses are interpolated.
  std::vector<RollingMoment> moments;

  /// The number of bands of equal height; the rows of a band share the time of their lights and
  /// shadows.
  int bands = 1;

  /// The poses when a row is taken. Orientations are interpolated at constant angular velocity, as
  /// in tf2. Before the first moment and after the last, everything is as it is at that moment.
  [[nodiscard]] RollingMoment at(double row) const;

  /// Like at(row), but only the poses of the given links are interpolated; the others are those of
  /// a moment nearby.
  [[nodiscard]] RollingMoment at(double row, const LinkSelection& links) const;

  /// The pose of a link in the camera's frame when a row is taken, as given by at().
  [[nodiscard]] Pose X_CL(std::size_t link, double row) const;

  /// The poses when the middle row is taken.
  [[nodiscard]] RollingMoment middle() const { return at(0.5 * (camera.height() - 1)); }

  /// The picture's rows that belong to a band.
  [[nodiscard]] cv::Rect rowsOf(int band) const;
};

}  // namespace synthetic_dataset::render
