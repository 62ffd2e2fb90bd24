#include "plugins/shared/pose_formats.h"

#include <cstdio>

namespace synthetic_dataset {

std::string sixDigits(std::int64_t number) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%06lld", static_cast<long long>(number));
  return buffer.data();
}

void warnOfDistortion(const CameraModel& camera, SceneOutput& output) {
  if (camera.isPinhole()) return;
  output.addWarning(
      "the format has no lens distortion: its camera matrix does not describe the image; "
      "`rectified: true` of the camera makes images that it does describe");
}

std::array<double, 9> cameraMatrix(const Intrinsics& intrinsics) {
  return {intrinsics.fx, 0.0, intrinsics.cx, 0.0, intrinsics.fy, intrinsics.cy, 0.0, 0.0, 1.0};
}

std::array<double, 9> rotationMatrix(const Pose& pose) {
  std::array<double, 9> rows{};
  for (int i = 0; i < 9; ++i) rows[static_cast<std::size_t>(i)] = pose.linear()(i / 3, i % 3);
  return rows;
}

Cuboid boundsOf(const ObjectModel& model) {
  Cuboid bounds{model.vertices.front().position, model.vertices.front().position};
  for (const ObjectModel::Vertex& vertex : model.vertices) {
    bounds.low = bounds.low.cwiseMin(vertex.position);
    bounds.high = bounds.high.cwiseMax(vertex.position);
  }
  return bounds;
}

}  // namespace synthetic_dataset
