#include "render/view.h"

namespace synthetic_dataset::render {

Eigen::Matrix4d clipFromCamera(const CameraModel& camera) {
  const Intrinsics& k = camera.intrinsics();
  const double near = camera.near();
  const double far = camera.far();
  Eigen::Matrix4d clip = Eigen::Matrix4d::Zero();
  clip(0, 0) = 2.0 * k.fx / camera.width();
  clip(0, 2) = 2.0 * (k.cx + 0.5) / camera.width() - 1.0;
  clip(1, 1) = 2.0 * k.fy / camera.height();
  clip(1, 2) = 2.0 * (k.cy + 0.5) / camera.height() - 1.0;
  clip(2, 2) = -near / (far - near);
  clip(2, 3) = near * far / (far - near);
  clip(3, 2) = 1.0;
  return clip;
}

}  // namespace synthetic_dataset::render
