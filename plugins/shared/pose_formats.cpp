#include "plugins/shared/pose_formats.h"

#include <algorithm>
#include <cstdio>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {
namespace {

bool isPinhole(const Distortion& distortion) {
  if (distortion.model == DistortionModel::kNone) return true;
  // Without coefficients the polynomials are 1, but a fisheye's angle is still not its tangent.
  return distortion.model != DistortionModel::kEquidistant &&
         std::all_of(distortion.coefficients.begin(), distortion.coefficients.end(),
                     [](double coefficient) { return coefficient == 0.0; });
}

}  // namespace

std::string sixDigits(std::int64_t number) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%06lld", static_cast<long long>(number));
  return buffer.data();
}

std::string cameraFolder(const DatasetInfo& dataset, std::size_t camera) {
  return dataset.cameras.size() < 2 ? "" : safeFileName(dataset.cameras[camera].name) + "/";
}

void warnOfDistortion(const CameraModel& camera, SceneOutput& output) {
  if (isPinhole(camera.distortion())) return;
  output.addWarning(
      "the format has no lens distortion: its camera matrix does not describe the image; "
      "`rectified: true` of the camera makes images that it does describe");
}

void refuseVaryingIntrinsics(const DatasetInfo& dataset, const std::string& file) {
  for (const CameraDescription& camera : dataset.cameras) {
    if (!camera.intrinsics_vary) continue;
    throw Error("found a camera, '" + camera.name +
                "', whose intrinsics differ from scene to scene, and the format has one " + file +
                " for all of its images; they should be the same: without "
                "randomize/sensor/field_of_view, and with the same calibration in all motions. "
                "BOP, DOPE, KITTI and others hold each image's own");
  }
}

void refuseVaryingModels(const DatasetInfo& dataset, const std::string& file) {
  for (const ObjectInfo& object : dataset.objects) {
    if (!object.model_varies) continue;
    throw Error("found an object, '" + object.name +
                "', whose model or size differs from scene to scene, and the format has one " +
                file +
                " of it for all images; it should be the same: without model and scale in "
                "randomize/objects, and with the same model in all motions. COCO, YOLO, KITTI and "
                "others hold what is seen in each image");
  }
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
