#include "plugins/readback/camera_drawing.h"

namespace synthetic_dataset::formats {
namespace {

cv::Point2d placeOf(const Eigen::Vector3d& p_C, const Intrinsics& camera) {
  return {camera.fx * p_C.x() / p_C.z() + camera.cx, camera.fy * p_C.y() / p_C.z() + camera.cy};
}

}  // namespace

void addLine(DrawnLabel& label, const Intrinsics& camera, const Eigen::Vector3d& a_C,
             const Eigen::Vector3d& b_C) {
  // Near limit as a fraction of the farther end's depth, so small that everything closer is outside
  // the image.
  constexpr double kNearest = 1e-3;
  const Eigen::Vector3d& far_C = a_C.z() > b_C.z() ? a_C : b_C;
  Eigen::Vector3d near_C = a_C.z() > b_C.z() ? b_C : a_C;
  const double nearest = kNearest * far_C.z();
  if (far_C.z() <= 0.0) return;
  if (near_C.z() < nearest) {
    near_C = far_C + (near_C - far_C) * ((far_C.z() - nearest) / (far_C.z() - near_C.z()));
  }
  label.lines.push_back({placeOf(near_C, camera), placeOf(far_C, camera)});
}

void addCuboid(DrawnLabel& label, const Intrinsics& camera,
               const std::array<Eigen::Vector3d, 8>& corners_C) {
  for (unsigned i = 0; i < 8; ++i) {
    for (const unsigned axis : {1U, 2U, 4U}) {
      if ((i & axis) == 0) addLine(label, camera, corners_C[i], corners_C[i | axis]);
    }
  }
}

void addAxes(DrawnLabel& label, const Intrinsics& camera, const Pose& X_CO, double length) {
  for (int axis = 0; axis < 3; ++axis) {
    addLine(label, camera, X_CO.translation(),
            X_CO.translation() + length * X_CO.linear().col(axis));
  }
}

}  // namespace synthetic_dataset::formats
