#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

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

}  // namespace synthetic_dataset::render
