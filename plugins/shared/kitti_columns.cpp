#include "plugins/shared/kitti_columns.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::kitti {
namespace {

constexpr double kLargestTilt = M_PI / 180.0;  // [rad]

/// In (-pi, pi].
double wrapped(double angle) { return std::remainder(angle, 2.0 * M_PI); }

/// The angle between the object's z axis and the camera's upward one [rad].
double tiltOf(const Pose& X_CO) { return std::acos(std::clamp(-X_CO.linear()(1, 2), -1.0, 1.0)); }

}  // namespace

std::string columns(std::initializer_list<double> numbers) {
  std::string text;
  for (const double number : numbers) text += " " + fixed(number, kKittiDecimals);
  return text;
}

std::string boxColumns(const Box& box) {
  return columns({box.left + 0.5, box.top + 0.5, box.right + 0.5, box.bottom + 0.5});
}

int occlusionOf(const PixelCounts& pixels) {
  const double seen = static_cast<double>(pixels.visible()) /
                      static_cast<double>(std::max<std::int64_t>(pixels.silhouette_in_image(), 1));
  if (seen >= 0.9) return 0;
  return seen >= 0.5 ? 1 : 2;
}

bool isTilted(const Pose& X_CO) { return tiltOf(X_CO) > kLargestTilt; }

Placement placementOf(const SceneObject& object) {
  const Cuboid& cuboid_O = object.cuboid_O;
  const Eigen::Vector3d centre_O = cuboid_O.centre();
  const Eigen::Vector3d bottom_C =
      *object.X_CO * Eigen::Vector3d(centre_O.x(), centre_O.y(), cuboid_O.low.z());
  const Eigen::Vector3d ahead_C = object.X_CO->linear().col(0);
  // A turn by rotation_y takes the camera's x axis to (cos, 0, -sin).
  const double rotation_y = std::atan2(-ahead_C.z(), ahead_C.x());
  const Eigen::Vector3d size = cuboid_O.size();
  return {wrapped(rotation_y - std::atan2(bottom_C.x(), bottom_C.z())),
          columns({size.z(), size.y(), size.x(), bottom_C.x(), bottom_C.y(), bottom_C.z(),
                   rotation_y})};
}

std::string calibration(const Intrinsics& k) {
  const std::string projection =
      columns({k.fx, 0.0, k.cx, 0.0, 0.0, k.fy, k.cy, 0.0, 0.0, 0.0, 1.0, 0.0}) + "\n";
  std::string text;
  for (const char* camera : {"P0:", "P1:", "P2:", "P3:"}) text += camera + projection;
  text += "R0_rect:" + columns({1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}) + "\n";
  // A scanner in the camera's place, with x ahead, y left and z up.
  text +=
      "Tr_velo_to_cam:" + columns({0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0}) +
      "\n";
  text +=
      "Tr_imu_to_velo:" + columns({1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0}) +
      "\n";
  return text;
}

}  // namespace synthetic_dataset::kitti
