#include "scene/camera_rig.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "base/diagnostics.h"
#include "base/name_list.h"
#include "motion/recorded/recorded_camera_info.h"
#include "randomize/placement/camera_sampler.h"
#include "scene/calibration/calibration_file.h"
#include "scene/link_names.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/nearest_name.h"
#include "synthetic_dataset/value.h"
#include "world/camera_frames.h"
#include "world/sensor_lookup.h"

namespace synthetic_dataset::scene {
namespace {

constexpr const char* kKind = "camera";  // kind of sensor, in messages

CalibrationUse useOf(const CameraOptions& config) {
  return {config.rectified, config.near.value(), config.far.value()};
}

CalibratedCamera readInfoFile(const CameraOptions& config) {
  try {
    return readCalibration(*config.info_file, config.info_choice, useOf(config));
  } catch (const ErrorList&) {
    throw;  // about the file's content
  } catch (const Error& error) {
    throw Error(config.group + "/info_file: " + error.what());
  }
}

/// Reads a camera's intrinsics and frame from the recording.
CalibratedCamera readRecordedInfo(const CameraOptions& config,
                                  const std::vector<std::string>& bag_files) {
  const std::string parameter = config.group + "/info_topic: ";
  try {
    const motion::RecordedCameraInfo recorded =
        motion::readCameraInfo(bag_files, *config.info_topic);
    CalibratedCamera camera =
        cameraOf(recorded.info, parameter + *config.info_topic, useOf(config));
    camera.frame = recorded.frame;
    camera.warnings.insert(camera.warnings.end(), recorded.notes.begin(), recorded.notes.end());
    return camera;
  } catch (const ErrorList&) {
    throw;  // names the parameter already
  } catch (const Error& error) {
    const std::string message = error.what();
    const bool named = message.rfind(parameter, 0) == 0;
    throw Error((named ? "" : parameter) + message);
  }
}

/// The camera of a sensor, with the near and far distances that are set, if any.
CameraModel modelOf(const world::CameraSensor& sensor, const CameraOptions& config) {
  const CameraModel& camera = sensor.camera;
  const double near = config.near.value_or(camera.near());
  const double far = config.far.value_or(camera.far());
  if (near < far) {
    return {camera.width(), camera.height(), camera.intrinsics(), near, far, camera.distortion()};
  }
  throw Error(config.group + (config.far ? "/far" : "/near") + ": found " +
              Value(config.far ? far : near).text() + "; the world's camera '" + sensor.name +
              "' sees from " + Value(camera.near()).text() + " to " + Value(camera.far()).text() +
              " m, so that nothing would be left");
}

/// The link of an object's model that a frame's name refers to, if the recording has no such frame.
/// @throws Error if several links match
std::optional<std::size_t> linkOfFrame(const std::string& frame,
                                       const std::vector<world::LinkInstance>& links,
                                       const std::vector<ObjectOptions>& objects) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const world::LinkInstance& link = links[i];
    if (link.role != world::Role::kObject || link.variant > 0) continue;
    const ObjectOptions& object = objects[static_cast<std::size_t>(link.object)];
    if (object.takes_part && isFrameOfLink(frame, link.link->name, object)) found.push_back(i);
  }
  if (found.empty()) return std::nullopt;
  world::requireFixedVariant(frame, kKind, links[found.front()], links);
  if (found.size() == 1) return found.front();
  std::vector<std::string> names;
  for (const std::size_t i : found) names.push_back(links[i].model + "/" + links[i].link->name);
  throw Error("found '" + frame + "', the name of the links " + base::listed(names) +
              "; OBJECT/LINK names one of them");
}

constexpr std::size_t kMostNamed = 8;  // objects, in messages

/// Mounts a camera on an object, or on a frame of something that has no labels.
void mount(const CameraOptions& config, const std::vector<ObjectOptions>& objects,
           const motion::FrameSource& frames, CameraRig& rig) {
  std::vector<std::string> names;
  for (const ObjectOptions& object : objects) {
    if (!object.takes_part) continue;
    if (object.name == *config.on) {
      rig.followed = frames.find(object.frame).value_or(motion::kNoFrame);
      return;
    }
    names.push_back(object.name);
  }
  if (const auto frame = frames.find(*config.on)) {
    rig.followed = *frame;
    rig.carrier = *config.on;
    return;
  }
  std::vector<std::string> near = names;
  near.insert(near.end(), frames.names().all().begin(), frames.names().all().end());
  throw Error(config.group + "/mounted_on: found '" + *config.on +
              "'; it should be an object of robot_list (" + base::listed(names, kMostNamed) +
              ") or a frame of " + frames.title() + didYouMean(*config.on, near));
}

/// The object that the camera keeps looking at.
FollowedObject followedBy(const CameraOptions& config, const std::vector<ObjectOptions>& objects,
                          const motion::FrameSource& frames) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (!objects[i].takes_part || objects[i].is_distractor) continue;
    if (objects[i].name == config.aim->look_at) {
      return {i, frames.find(objects[i].frame).value_or(motion::kNoFrame)};
    }
    names.push_back(objects[i].name);
  }
  throw Error(config.group + "/pose/look_at: found '" + config.aim->look_at +
              "'; it should be an object of robot_list (" + base::listed(names, kMostNamed) +
              ") or a point [x, y, z]" + didYouMean(config.aim->look_at, names));
}

/// The pose of a camera that does not move relative to the frame of its position.
Pose standingPose(const CameraAim& aim) {
  if (aim.look_at_point_G) return randomize::lookingAt(aim.position_G, *aim.look_at_point_G, 0.0);
  const Eigen::Vector3d rpy = aim.rpy.value_or(Eigen::Vector3d::Zero());
  const Eigen::Quaterniond R_GB = Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
                                  Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
                                  Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX());
  return makePose(aim.position_G, R_GB) * world::opticalInBody();
}

/// The pose given in numbers, if any: in the global frame, or in the carrier's.
std::optional<Pose> givenPose(const CameraOptions& config) {
  if (!config.aim) return config.X_GC;
  if (config.aim->look_at.empty()) return standingPose(*config.aim);
  return makePose(config.aim->position_G, Eigen::Quaterniond::Identity());
}

void findPose(const CameraOptions& config, const world::CameraSensor* sensor,
              const std::vector<world::LinkInstance>& links,
              const std::vector<ObjectOptions>& objects, const motion::FrameSource& frames,
              CameraRig& rig) {
  rig.sampled = config.sample.has_value();
  if (rig.sampled) return;
  if (config.aim && !config.aim->look_at.empty()) {
    rig.looks_at = followedBy(config, objects, frames);
  }
  if (config.on) {
    rig.is_carried = true;
    mount(config, objects, frames, rig);
    rig.X_LC = givenPose(config).value_or(Pose::Identity());
    return;
  }
  if (rig.looks_at) {
    rig.X_LC = *givenPose(config);
    return;
  }
  rig.X_GC = givenPose(config);
  rig.followed = frames.find(rig.frame).value_or(motion::kNoFrame);
  if (rig.X_GC || rig.followed != motion::kNoFrame) return;
  if (sensor != nullptr) {
    rig.link = base::namingPlace(config.group + "/sensor",
                                 [&] { return world::movingLinkOf(*sensor, kKind, links); });
    rig.X_LC = sensor->X_LC;
    if (!rig.link) rig.X_GC = sensor->X_WC;
    return;
  }
  const std::string frame_id =
      config.group == "camera" ? "camera_frame_id" : config.group + "/frame_id";
  rig.link = base::namingPlace(frame_id, [&] { return linkOfFrame(rig.frame, links, objects); });
  if (rig.link) return;
  throw Error(config.group + ": nothing says where it is; " + config.group +
              "/pose should, or sample, mounted_on or sensor, or " + frame_id +
              " should name a frame, of the recording or a link of an object's model: " +
              frames.lacks(rig.frame));
}

/// The settings' effects; noise that is not set is taken from the world's sensor.
render::SensorEffects effectsOf(const CameraOptions& config, const world::CameraSensor* sensor) {
  const world::PixelNoise own = sensor != nullptr ? sensor->noise : world::PixelNoise();
  render::SensorEffects effects = config.effects;
  effects.noise_mean = config.noise_mean.value_or(own.mean);
  effects.noise_stddev = config.noise_stddev.value_or(own.stddev);
  return effects;
}

CalibratedCamera calibrationOf(const CameraOptions& config,
                               const std::vector<std::string>& bag_files,
                               const world::CameraSensor* sensor) {
  if (config.info_file) return readInfoFile(config);
  if (config.info_topic) return readRecordedInfo(config, bag_files);
  if (sensor != nullptr) return {modelOf(*sensor, config)};
  throw Error(config.group + ": no intrinsics");
}

/// The frame that is set, or else that of the calibration, if TF has it and lacks the default one.
std::string frameOf(const CameraOptions& config, const CalibratedCamera& camera,
                    const motion::FrameSource& frames) {
  if (!config.frame) return camera.frame;
  const bool takes_own = !config.frame_is_given && !camera.frame.empty() &&
                         !frames.find(*config.frame) && frames.find(camera.frame);
  return takes_own ? camera.frame : *config.frame;
}

/// Sets the picture's frame if it differs from the calibrated camera's. If the camera is sampled,
/// the picture's frame itself is what is placed in each scene.
void placeInFrame(const CameraOptions& config, const CalibratedCamera& camera, CameraRig& rig) {
  rig.is_rectified = config.rectified;
  rig.stereo_frame = config.stereo_frame;
  rig.optical_frame = rig.frame;
  if (rig.sampled || camera.X_FC.isApprox(Pose::Identity(), 0.0)) return;
  rig.X_FC = camera.X_FC;
  rig.optical_frame = rig.frame + "/" + rig.name;
}

}  // namespace

CameraRig makeCameraRig(const CameraOptions& config, const std::vector<std::string>& bag_files,
                        const std::vector<world::CameraSensor>& sensors,
                        const std::vector<world::LinkInstance>& links,
                        const std::vector<ObjectOptions>& objects,
                        const motion::FrameSource& frames, base::Diagnostics& diagnostics) {
  const world::CameraSensor* sensor =
      config.sensor ? &world::findSensor(*config.sensor, sensors, config.group + "/sensor", kKind,
                                         diagnostics)
                    : nullptr;
  const CalibratedCamera camera = calibrationOf(config, bag_files, sensor);
  for (const std::string& warning : camera.warnings) {
    diagnostics.warning(config.group + (config.info_topic ? "/info_topic" : "/info_file"), warning);
  }
  CameraRig rig{config.name, withFocalScale(camera.model, config.focal_scale),
                frameOf(config, camera, frames)};
  findPose(config, sensor, links, objects, frames, rig);
  placeInFrame(config, camera, rig);
  rig.X_FD = config.X_FD;
  rig.shutter = config.shutter;
  rig.effects = effectsOf(config, sensor);
  rig.depth_noise = config.depth_noise;
  return rig;
}

void checkInfoFile(const CameraOptions& config) {
  CameraOptions with_range = config;  // near and far do not matter for the check
  with_range.near = config.near.value_or(0.1);
  with_range.far = config.far.value_or(1000.0);
  if (config.info_file) (void)readInfoFile(with_range);
}

double seenShare(const CameraModel& camera) {
  constexpr int kSteps = 24;  // per side of a grid of pixels
  int seen = 0;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const Eigen::Vector2d pixel((i + 0.5) / kSteps * camera.width() - 0.5,
                                  (j + 0.5) / kSteps * camera.height() - 0.5);
      seen += camera.ray(pixel).has_value() ? 1 : 0;
    }
  }
  return static_cast<double>(seen) / (kSteps * kSteps);
}

CameraModel withFocalScale(const CameraModel& camera, double scale) {
  Intrinsics scaled = camera.intrinsics();
  scaled.fx *= scale;
  scaled.fy *= scale;
  return {camera.width(), camera.height(), scaled,
          camera.near(),  camera.far(),    camera.distortion()};
}

}  // namespace synthetic_dataset::scene
