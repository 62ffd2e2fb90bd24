#include "camera_rig.h"

#include <algorithm>

#include "config/camera_info.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset {
namespace {

const world::CameraSensor* findSensor(const config::CameraConfig& config,
                                      const world::Description& world) {
  if (!config.sensor) return nullptr;
  const auto found = std::find_if(
      world.cameras.begin(), world.cameras.end(),
      [&](const world::CameraSensor& camera) { return camera.name == *config.sensor; });
  if (found != world.cameras.end()) return &*found;
  std::string there;
  for (const world::CameraSensor& camera : world.cameras) {
    there += (there.empty() ? "" : ", ") + camera.name;
  }
  throw Error("camera/sensor: the world has no camera '" + *config.sensor +
              "' (model::link::sensor); it has " + (there.empty() ? "none" : there));
}

CameraModel findModel(const config::CameraConfig& config, const world::CameraSensor* sensor) {
  if (config.info_file) {
    return config::readCameraInfo(*config.info_file, config.rectified, config.near, config.far);
  }
  if (sensor == nullptr) throw Error("camera: no intrinsics");
  return sensor->camera;
}

std::optional<Pose> findPose(const config::CameraConfig& config, const world::CameraSensor* sensor,
                             const motion::BagMotion& recording) {
  if (config.X_GC) return config.X_GC;
  if (recording.knowsFrame(config.frame)) return std::nullopt;
  if (sensor != nullptr) return sensor->X_WC;
  throw Error("camera_frame_id: found '" + config.frame +
              "', a frame that the recording does not have (name one of its frames, or give "
              "camera/pose or camera/sensor)" +
              recording.suggestFrame(config.frame));
}

}  // namespace

CameraRig makeCameraRig(const config::CameraConfig& config, const world::Description& world,
                        const motion::BagMotion& recording) {
  const world::CameraSensor* sensor = findSensor(config, world);
  return CameraRig{findModel(config, sensor), config.frame, findPose(config, sensor, recording)};
}

}  // namespace synthetic_dataset
