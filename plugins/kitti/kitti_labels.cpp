#include "plugins/kitti/kitti_labels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "synthetic_dataset/box_choice.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::kitti {
namespace {

constexpr double kLargestTilt = M_PI / 180.0;  // [rad]

/// Wraps an angle into (-pi, pi].
double wrapped(double angle) { return std::remainder(angle, 2.0 * M_PI); }

/// Whether the object's z axis deviates so much from the camera's upward axis that a rotation about
/// the camera's y axis does not describe its orientation.
bool isTilted(const Pose& X_CO) {
  return std::acos(std::clamp(-X_CO.linear()(1, 2), -1.0, 1.0)) > kLargestTilt;
}

/// The numbers, each preceded by a space.
std::string columns(const std::vector<double>& numbers) {
  constexpr int kDecimals = 6;
  std::string text;
  for (const double number : numbers) text += " " + fixed(number, kDecimals);
  return text;
}

/// Left, top, right, bottom. KITTI counts pixels from the image's edge, not from the first pixel's
/// centre.
std::string boxColumns(const Box& box) {
  return columns({box.left + 0.5, box.top + 0.5, box.right + 0.5, box.bottom + 0.5});
}

/// 0 fully visible, 1 partly occluded, 2 largely occluded: of the part in the image.
int occlusionOf(const PixelCounts& pixels) {
  const double seen = static_cast<double>(pixels.visible()) /
                      static_cast<double>(std::max<std::int64_t>(pixels.silhouette_in_image(), 1));
  if (seen >= 0.9) return 0;
  return seen >= 0.5 ? 1 : 2;
}

/// The tracking benchmark has integers where the object benchmark has fractions: 0 not, 1 partly, 2
/// largely outside the image.
int truncationOf(double share) {
  constexpr double kNone = 0.01;
  if (share < kNone) return 0;
  return share <= 0.5 ? 1 : 2;
}

/// The columns after the type. Length is along the object's x axis, width along y, height along z.
std::string placementOf(const SceneObject& object, const Box& box) {
  const Cuboid& cuboid_O = object.cuboid_O;
  const Eigen::Vector3d centre_O = cuboid_O.centre();
  const Eigen::Vector3d bottom_C =
      *object.X_CO * Eigen::Vector3d(centre_O.x(), centre_O.y(), cuboid_O.low.z());
  const Eigen::Vector3d ahead_C = object.X_CO->linear().col(0);
  // A rotation by rotation_y maps the camera's x axis to (cos, 0, -sin).
  const double rotation_y = std::atan2(-ahead_C.z(), ahead_C.x());
  const double alpha = wrapped(rotation_y - std::atan2(bottom_C.x(), bottom_C.z()));
  const Eigen::Vector3d size = cuboid_O.size();
  return " " + std::to_string(occlusionOf(object.pixels)) + columns({alpha}) + boxColumns(box) +
         columns(
             {size.z(), size.y(), size.x(), bottom_C.x(), bottom_C.y(), bottom_C.z(), rotation_y});
}

/// An object's line; empty if it has no box in the image.
std::string lineOf(const SceneObject& object, const CameraModel& camera,
                   const KittiOptions& options, Benchmark benchmark) {
  const auto box = boxOf(object, options.box, camera);
  if (!box) return "";
  const std::string& type = options.types.at(object.class_name);
  const std::string placement = placementOf(object, *box) + "\n";
  if (benchmark == Benchmark::kObjects) return type + columns({object.truncation()}) + placement;
  return std::to_string(object.instance - 1) + " " + type + " " +
         std::to_string(truncationOf(object.truncation())) + placement;
}

std::string dontCareLineOf(const SceneObject& object, const CameraModel& camera,
                           Benchmark benchmark) {
  const auto box = boxOf(object, BoxChoice::kVisible, camera);
  if (!box) return "";
  const std::string line = std::string(kDontCare) + " -1 -1 -10" + boxColumns(*box);
  return benchmark == Benchmark::kObjects ? line + " -1 -1 -1 -1000 -1000 -1000 -10\n"
                                          : "-1 " + line + " -1000 -1000 -1000 -10 -1 -1 -1\n";
}

/// Whether the lidar has enough points on an object. @param index  in Scene::objects
bool hasEnoughPoints(const Scene& scene, std::size_t index, const KittiOptions& options) {
  if (!options.lidar || options.min_points == 0) return true;
  return scene.clouds().at(*options.lidar)->points_of_objects.at(index) >= options.min_points;
}

}  // namespace

Requirements requirementsOf(const KittiOptions& options) {
  Requirements requirements;
  requirements.visible_masks = true;
  requirements.visibility = true;
  requirements.depth = options.velodyne;
  if (options.lidar) {
    requirements.clouds = true;
    requirements.frames = {options.lidar_frame};
  }
  return requirements;
}

std::string labels(const Scene& scene, const KittiOptions& options, Benchmark benchmark,
                   SceneOutput& output) {
  std::string lines;
  bool is_tilted = false;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& object = scene.objects[i];
    if (object.labelled() && hasEnoughPoints(scene, i, options)) {
      lines += lineOf(object, scene.camera, options, benchmark);
      is_tilted = is_tilted || isTilted(*object.X_CO);
    } else if (options.dont_care && object.pixels.visible() > 0) {
      lines += dontCareLineOf(object, scene.camera, benchmark);
    }
  }
  if (is_tilted) {
    output.addWarning(
        "an object is tilted against the camera by more than 1 degree: KITTI's labels have only "
        "its rotation about the camera's y axis");
  }
  return lines;
}

std::string calibration(const Intrinsics& k, const Pose& X_CS) {
  const std::string projection =
      columns({k.fx, 0.0, k.cx, 0.0, 0.0, k.fy, k.cy, 0.0, 0.0, 0.0, 1.0, 0.0}) + "\n";
  std::string text;
  for (const char* camera : {"P0:", "P1:", "P2:", "P3:"}) text += camera + projection;
  text += "R0_rect:" + columns({1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}) + "\n";
  std::vector<double> matrix;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) matrix.push_back(X_CS.matrix()(row, column));
  }
  text += "Tr_velo_to_cam:" + columns(matrix) + "\n";
  text +=
      "Tr_imu_to_velo:" + columns({1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0}) +
      "\n";
  return text;
}

Pose scannerInCamera() {
  Pose X_CS = Pose::Identity();
  X_CS.linear() << 0.0, -1.0, 0.0, 0.0, 0.0, -1.0, 1.0, 0.0, 0.0;
  return X_CS;
}

Pose lidarInCamera(const Scene& scene, const KittiOptions& options) {
  return scene.X_GC.inverse() * scene.transform(options.global_frame, options.lidar_frame);
}

std::string lidarPoints(const Scene& scene, const KittiOptions& options) {
  return velodyneFile(*scene.clouds().at(*options.lidar), options.positions);
}

}  // namespace synthetic_dataset::kitti
