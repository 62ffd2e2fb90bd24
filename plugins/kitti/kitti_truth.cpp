#include "plugins/kitti/kitti_truth.h"

#include <algorithm>
#include <cmath>

#include "plugins/readback/files.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::formats {
namespace {

/// Edges as the format counts them: the image spans 0 to its width.
std::string edgesOf(const Box& box) {
  return kittiWords({box.left + 0.5, box.top + 0.5, box.right + 0.5, box.bottom + 0.5});
}

/// The devkit's readme: 0 fully visible, 1 partly, 2 largely occluded; by what is in the image.
int occlusionOf(const PixelCounts& pixels) {
  const auto in_image =
      static_cast<double>(std::max<std::int64_t>(1, pixels.silhouette_in_image()));
  const double seen = static_cast<double>(pixels.visible()) / in_image;
  return seen >= 0.9 ? 0 : seen >= 0.5 ? 1 : 2;
}

/// In -pi .. pi.
double turned(double angle) { return std::atan2(std::sin(angle), std::cos(angle)); }

std::string withoutHalfTurns(std::string text) {
  const std::string minus_pi = " " + fixed(-M_PI, kKittiDecimals);
  for (std::size_t at = 0; (at = text.find(minus_pi, at)) != std::string::npos; ++at) {
    text.erase(at + 1, 1);
  }
  return text;
}

}  // namespace

std::optional<TrueKittiLine> trueKittiLine(const SceneObject& object, const CameraModel& camera,
                                           const KittiOptions& options) {
  if (!object.labelled()) {
    const bool is_seen = options.dont_care && object.pixels.visible() > 0;
    const auto box = is_seen ? boxOf(object, BoxChoice::kVisible, camera) : std::nullopt;
    if (!box) return std::nullopt;
    return TrueKittiLine{kDontCare, edgesOf(*box)};
  }
  const auto box = boxOf(object, options.box, camera);
  if (!box) return std::nullopt;
  // The devkit's readme: height, width, length; the location is the middle of the lower face;
  // rotation_y turns about the camera's y axis, which looks down; alpha is that seen from here.
  const Cuboid& cuboid = object.cuboid_O;
  const Eigen::Vector3d size = cuboid.high - cuboid.low;
  const Eigen::Vector3d foot_O(0.5 * (cuboid.low.x() + cuboid.high.x()),
                               0.5 * (cuboid.low.y() + cuboid.high.y()), cuboid.low.z());
  const Eigen::Vector3d foot_C = *object.X_CO * foot_O;
  const Eigen::Vector3d ahead_C = object.X_CO->linear() * Eigen::Vector3d::UnitX();
  const double rotation = std::atan2(-ahead_C.z(), ahead_C.x());
  return TrueKittiLine{
      options.types.at(object.class_name), edgesOf(*box),
      turned(rotation - std::atan2(foot_C.x(), foot_C.z())), occlusionOf(object.pixels),
      kittiWords({size.z(), size.y(), size.x(), foot_C.x(), foot_C.y(), foot_C.z(), rotation})};
}

std::string kittiWords(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += " " + fixed(number, kKittiDecimals);
  return text;
}

std::string trueKittiCalibration(const Intrinsics& k) {
  std::string text;
  for (const char* camera : {"P0:", "P1:", "P2:", "P3:"}) {
    text += camera + kittiWords({k.fx, 0, k.cx, 0, 0, k.fy, k.cy, 0, 0, 0, 1, 0}) + "\n";
  }
  text += "R0_rect:" + kittiWords({1, 0, 0, 0, 1, 0, 0, 0, 1}) + "\n";
  // A scanner where the camera is, x ahead, y left, z up, and an IMU there too.
  text += "Tr_velo_to_cam:" + kittiWords({0, -1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0}) + "\n";
  text += "Tr_imu_to_velo:" + kittiWords({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}) + "\n";
  return text;
}

void compareKittiLabels(const std::string& name, const std::string& lines, FoundFiles& files) {
  const auto file = files.take(name);
  if (!file) return;
  compareText(withoutHalfTurns(readText(*file)), withoutHalfTurns(lines), name,
              files.differences());
}

}  // namespace synthetic_dataset::formats
