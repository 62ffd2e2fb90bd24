#include "world/sdf/sdf_cameras.h"

#include <cmath>
#include <string>

#include <sdf/Camera.hh>

#include "synthetic_dataset/errors.h"
#include "world/camera_frames.h"
#include "world/sdf/sdf_lenses.h"

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

// The range of sight of cameras without <clip>.
constexpr double kNear = 0.05;   // [m]
constexpr double kFar = 1000.0;  // [m]

CameraModel modelOf(const sdf::Camera& camera, bool wide_angle) {
  const sdf::ElementPtr clip = descendant(camera.Element(), {"clip"});
  const Lens lens = wide_angle ? wideAngleLens(camera)
                               : Lens{intrinsicsOf(camera), brownDistortion(camera.Element())};
  return CameraModel(static_cast<int>(camera.ImageWidth()), static_cast<int>(camera.ImageHeight()),
                     lens.intrinsics, clip ? camera.NearClip() : kNear,
                     clip ? camera.FarClip() : kFar, lens.distortion);
}

bool isPinhole(const sdf::Sensor& sensor) {
  return sensor.Type() == sdf::SensorType::CAMERA ||
         sensor.Type() == sdf::SensorType::DEPTH_CAMERA ||
         sensor.Type() == sdf::SensorType::RGBD_CAMERA;
}

/// By its element: not every version of libsdformat has a type for it.
bool isWideAngle(const sdf::Sensor& sensor) {
  return sensor.Element() && sensor.Element()->Get<std::string>("type") == "wideanglecamera";
}

/// The camera of a sensor, and whether there is one.
bool loadCamera(const sdf::Sensor& sensor, sdf::Camera& camera) {
  if (isPinhole(sensor) && sensor.CameraSensor() != nullptr) {
    camera = *sensor.CameraSensor();
    return true;
  }
  if (!isWideAngle(sensor) || !has(sensor.Element(), "camera")) return false;
  camera.Load(sensor.Element()->GetElement("camera"));
  return true;
}

PixelNoise noiseOf(const sdf::Camera& camera) {
  const sdf::ElementPtr noise = descendant(camera.Element(), {"noise"});
  if (!noise) return {};
  const PixelNoise result{number(noise, {"mean"}, 0.0), number(noise, {"stddev"}, 0.0)};
  if (!(result.stddev >= 0.0 && result.stddev <= 1.0) || !(std::abs(result.mean) <= 1.0)) {
    throw Error("noise: found a mean of " + std::to_string(result.mean) +
                " and a standard deviation of " + std::to_string(result.stddev) +
                "; they are shares of full scale, -1 to 1 and 0 to 1");
  }
  return result;
}

}  // namespace

std::optional<CameraSensor> readCamera(const sdf::Sensor& sensor, const std::string& name,
                                       const Pose& X_WL, const Place& place, SdfReading& reading) {
  sdf::Camera camera;
  if (!loadCamera(sensor, camera)) return std::nullopt;
  const Place here = place.in("sensor", sensor.Name());
  const Pose X_LS = resolve(sensor.SemanticPose(), here, reading);
  try {
    const Pose X_LC = X_LS * toPose(camera.RawPose()) * opticalInBody();
    return CameraSensor{name, X_WL * X_LC, modelOf(camera, isWideAngle(sensor)), noiseOf(camera),
                        "",   X_LC};
  } catch (const UnsupportedLens& error) {
    reading.findings.addNote(here.message(error.what()) + "; the camera is left out");
  } catch (const Error& error) {
    reading.findings.addError(here.message(error.what()));
  }
  return std::nullopt;
}

}  // namespace synthetic_dataset::world
