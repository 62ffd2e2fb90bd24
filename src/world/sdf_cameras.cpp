#include "world/sdf_cameras.h"

#include <cmath>

#include <sdf/Camera.hh>

#include "synthetic_dataset/errors.h"
#include "world/camera_frames.h"

namespace synthetic_dataset::world {
namespace {

/// fx = width / (2 tan(hfov / 2)) with square pixels, as Gazebo's camera has it. Its optical axis
/// meets the middle of the image, which is (width - 1) / 2 where pixel centres are whole.
Intrinsics fromFieldOfView(const sdf::Camera& camera) {
  const double width = camera.ImageWidth();
  const double height = camera.ImageHeight();
  const double angle = camera.HorizontalFov().Radian();
  if (!(angle > 0.0 && angle < 3.14159)) {
    throw Error("horizontal_fov: found " + std::to_string(angle) +
                "; it should be above 0 and below pi rad");
  }
  const double focal_length = width / (2.0 * std::tan(0.5 * angle));
  return {focal_length, focal_length, 0.5 * (width - 1.0), 0.5 * (height - 1.0)};
}

/// Intrinsics in the file are those that camera_info is to say.
Intrinsics intrinsicsOf(const sdf::Camera& camera) {
  if (!descendant(camera.Element(), {"lens", "intrinsics"})) return fromFieldOfView(camera);
  return {camera.LensIntrinsicsFx(), camera.LensIntrinsicsFy(), camera.LensIntrinsicsCx(),
          camera.LensIntrinsicsCy()};
}

CameraModel modelOf(const sdf::Camera& camera, const SdfLoadOptions& options) {
  const sdf::ElementPtr clip = descendant(camera.Element(), {"clip"});
  return CameraModel(static_cast<int>(camera.ImageWidth()), static_cast<int>(camera.ImageHeight()),
                     intrinsicsOf(camera), clip ? camera.NearClip() : options.default_near,
                     clip ? camera.FarClip() : options.default_far);
}

bool isPinhole(const sdf::Sensor& sensor) {
  return sensor.Type() == sdf::SensorType::CAMERA ||
         sensor.Type() == sdf::SensorType::DEPTH_CAMERA ||
         sensor.Type() == sdf::SensorType::RGBD_CAMERA;
}

}  // namespace

std::optional<CameraSensor> readCamera(const sdf::Sensor& sensor, const std::string& name,
                                       const Pose& X_WL, const SdfLoadOptions& options,
                                       const Place& place, SdfReading& reading) {
  const sdf::Camera* camera = isPinhole(sensor) ? sensor.CameraSensor() : nullptr;
  if (camera == nullptr) return std::nullopt;
  const Place here = place.in("sensor", sensor.Name());
  const Pose X_LS = resolve(sensor.SemanticPose(), here, reading);
  try {
    return CameraSensor{name, X_WL * X_LS * toPose(camera->RawPose()) * opticalInBody(),
                        modelOf(*camera, options)};
  } catch (const Error& error) {
    reading.findings.addError(here.message(error.what()));
    return std::nullopt;
  }
}

}  // namespace synthetic_dataset::world
