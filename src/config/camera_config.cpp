#include "config/readers.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/seconds.h"
#include "config/checked_values.h"
#include "config/distribution_config.h"
#include "config/pose_config.h"

namespace synthetic_dataset::config {
namespace {

/// `look_at: NAME | [x, y, z]`.
void readLookAt(Parameters& group, scene::CameraAim& aim) {
  const auto given = group.maybe<Value>("look_at");
  if (given && given->is<std::string>()) {
    aim.look_at = *given->as<std::string>();
  } else if (given) {
    aim.look_at_point_G = maybeVector(group, "look_at", kFarthest,
                                      "an object of robot_list or a point [x, y, z] [m]");
  }
}

/// `pose: {position: [x, y, z], look_at: ...}` or `{position, rpy: [roll, pitch, yaw]}`.
scene::CameraAim readAim(Parameters group) {
  scene::CameraAim aim;
  if (!group.has("position")) (void)group.required<Value>("position");
  const auto position = maybeVector(group, "position", kFarthest, "[x, y, z] [m]");
  aim.position_G = position.value_or(aim.position_G);
  aim.rpy = maybeAngles(group);
  readLookAt(group, aim);
  if (group.has("rpy") == group.has("look_at")) {
    group.addError(group.has("rpy") ? "rpy" : "look_at",
                   std::string(group.has("rpy") ? "found together with" : "missing, and so is") +
                       (group.has("rpy") ? " look_at" : " rpy") +
                       "; a camera's direction should come from one of them");
  }
  const auto& point = aim.look_at_point_G;
  constexpr double kNoDirection = 1e-9;  // [m]
  if (position && point && (*point - *position).norm() < kNoDirection) {
    group.addError("look_at", "found the camera's own position; it should be another point");
  }
  return aim;
}

scene::StereoFrame readStereoFrame(Parameters& group, bool is_rectified) {
  const auto frame = listedChoice<scene::StereoFrame>(group, "stereo_frame",
                                                      {{"auto", scene::StereoFrame::kAuto},
                                                       {"first", scene::StereoFrame::kFirst},
                                                       {"own", scene::StereoFrame::kOwn}});
  if (!is_rectified) {
    group.addError("stereo_frame",
                   "found without `rectified: true`; it applies to rectified cameras");
  }
  return frame;
}

const char* const kOrAim =
    ", or {position: [x, y, z], look_at: OBJECT or [x, y, z]}, or {position: [x, y, z], rpy: "
    "[roll, pitch, yaw]}";

void readEffects(Parameters group, scene::CameraOptions& camera) {
  constexpr double kMostStops = 10.0;
  constexpr double kLongestExposure = 10.0;  // [s]
  constexpr double kWidestBlur = 50.0;       // [px]
  constexpr double kLargestWell = 1e9;       // electrons
  const auto read = [&](const std::string& name, double low, double high) {
    return group.maybeBetween(name, low, high).value_or(0.0);
  };
  render::SensorEffects& effects = camera.effects;
  scene::Shutter& shutter = camera.shutter;
  effects.exposure = read("exposure", -kMostStops, kMostStops);
  shutter.exposure_time = base::fromSeconds(read("exposure_time", 0.0, kLongestExposure));
  shutter.readout_time = base::fromSeconds(read("readout_time", 0.0, kLongestExposure));
  const auto checkHasTime = [&](const char* name, const char* time) {
    if (!group.has(name) || group.has(time)) return;
    group.addError(name, "has no effect without " + std::string(time) + "; set both or none");
  };
  checkHasTime("motion_samples", "exposure_time");
  checkHasTime("readout_bands", "readout_time");
  if (shutter.exposure_time.count() > 0 || group.has("motion_samples")) {
    shutter.motion_samples =
        group.optionalBetween("motion_samples", shutter.motion_samples, 2, 256);
  }
  if (shutter.readout_time.count() > 0 || group.has("readout_bands")) {
    shutter.readout_bands = group.optionalBetween("readout_bands", shutter.readout_bands, 2, 4096);
  }
  effects.blur = read("blur", 0.0, kWidestBlur);
  effects.vignetting = read("vignetting", 0.0, 1.0);
  effects.full_well = read("full_well", 0.0, kLargestWell);
  effects.white_balance =
      group.maybeBetween("white_balance", render::kReddestLight, render::kBluestLight)
          .value_or(render::kNeutralWhite);
  effects.jpeg_quality = group.maybeBetween("jpeg_quality", 1, 100).value_or(0);
  camera.noise_mean = group.maybeBetween("noise_mean", -1.0, 1.0);
  camera.noise_stddev = group.maybeBetween("noise_stddev", 0.0, 1.0);
}

/// Reads `near` and `far`; for a camera of the world, those not set are the world's.
void readRange(Parameters& group, scene::CameraOptions& camera) {
  constexpr double kNear = 0.05;   // [m]
  constexpr double kFar = 1000.0;  // [m]
  const bool is_of_world = camera.sensor && !camera.info_file && !camera.info_topic;
  if (!is_of_world || group.has("near")) camera.near = numberAbove(group, "near", kNear, 0.0);
  if (!is_of_world || group.has("far")) {
    camera.far = numberAbove(group, "far", kFar, camera.near.value_or(0.0));
  }
}

/// Reads the topic of recorded pictures, and how their clock, frame and lens differ from what is
/// recorded.
void readTwin(Parameters& group, scene::CameraOptions& camera) {
  constexpr double kLongestOffset = 10.0;  // [s]
  camera.image_topic = group.maybe<std::string>("image_topic");
  const auto offset = group.maybeBetween("time_offset", -kLongestOffset, kLongestOffset);
  if (offset && !camera.image_topic) {
    group.addError("time_offset", "found without image_topic, to whose pictures it applies");
  }
  camera.time_offset = base::fromSeconds(offset.value_or(0.0));
  constexpr double kWidest = 0.5;
  constexpr double kNarrowest = 2.0;
  camera.focal_scale = group.maybeBetween("focal_scale", kWidest, kNarrowest).value_or(1.0);
  if (group.has("correction")) camera.X_FD = readPose(group, "correction", kOrAim);
  if (camera.X_FD && camera.sample) {
    group.addError("correction", "found together with sample, whose cameras stand where it says");
  }
  if (camera.image_topic && camera.sample) {
    group.addError("sample",
                   "found together with image_topic; a recorded picture was taken from one place");
  }
}

/// Reads the settings that a camera has whether it is the only one or not.
scene::CameraOptions readCamera(Parameters group, const std::string& name,
                                std::optional<std::string> frame) {
  scene::CameraOptions camera;
  camera.name = name;
  camera.group = group.fullName("");
  camera.info_file = group.maybe<std::string>("info_file");
  if (camera.info_file) camera.info_file = absolutePath(*camera.info_file);
  camera.info_choice.camera = group.maybe<std::string>("info_camera");
  camera.info_choice.reference = group.maybe<std::string>("info_reference");
  camera.info_topic = group.maybe<std::string>("info_topic");
  camera.sensor = group.maybe<std::string>("sensor");
  const auto pose = group.has("pose") ? group.maybe<Value>("pose") : std::nullopt;
  if (pose && pose->is<Value::Map>()) {
    camera.aim = readAim(group.group("pose"));
  } else if (pose) {
    camera.X_GC = readPose(group, "pose", kOrAim);
  }
  camera.on = group.maybe<std::string>("mounted_on");
  camera.sample = readCameraSampling(group);
  if (camera.sample && (camera.X_GC || camera.aim || camera.on)) {
    group.addError("sample",
                   "found together with pose or mounted_on; a camera stands somewhere, or is "
                   "put somewhere else for each scene");
  }
  readTwin(group, camera);
  const bool is_rectified = camera.image_topic && isRectifiedTopic(*camera.image_topic);
  camera.rectified = group.maybe<bool>("rectified").value_or(is_rectified);
  if (group.has("stereo_frame")) camera.stereo_frame = readStereoFrame(group, camera.rectified);
  readRange(group, camera);
  readEffects(group.group("effects"), camera);
  camera.depth_noise = readDepthNoise(group);
  camera.frame = group.maybe<std::string>("frame_id");
  if (!camera.frame) camera.frame = std::move(frame);
  camera.frame_is_given = camera.frame.has_value();
  if (!camera.frame && !camera.info_topic) {
    camera.frame = group.optional<std::string>("frame_id", name + "/optical_link");
  }
  return camera;
}

void checkIntrinsicsNamed(const scene::CameraOptions& camera, Parameters& above,
                          const std::string& name) {
  if (camera.info_file && camera.info_topic) {
    above.addError(name, "found both info_file and info_topic; intrinsics should come from one");
  }
  if (!camera.info_file && (camera.info_choice.camera || camera.info_choice.reference)) {
    above.addError(name,
                   "found info_camera or info_reference without info_file, from whose "
                   "cameras they choose");
  }
  if (camera.info_file || camera.info_topic || camera.sensor) return;
  above.addError(name, "no intrinsics; " + camera.group +
                           "/info_file should name a camera_info YAML file, " + camera.group +
                           "/info_topic a topic of the bag, or " + camera.group +
                           "/sensor a camera of the world");
}

}  // namespace

std::vector<std::string> folderNames(Parameters& group) {
  const char* allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
  constexpr std::size_t kLongest = 80;
  std::vector<std::string> good;
  for (const std::string& name : group.names()) {
    const bool is_good = !name.empty() && name.size() <= kLongest && name.front() != '.' &&
                         name.find_first_not_of(allowed) == std::string::npos;
    if (is_good) {
      good.push_back(name);
      continue;
    }
    group.ignore(name);
    group.addError(
        name, "is not a valid folder name; up to 80 letters, digits, '_', '-' and '.' are allowed");
  }
  return good;
}

bool isRectifiedTopic(const std::string& topic) {
  return topic.find("/image_rect") != std::string::npos;
}

std::vector<scene::CameraOptions> readCameras(Parameters root) {
  std::vector<scene::CameraOptions> cameras;
  if (!root.has("cameras")) {
    auto frame = root.maybe<std::string>("camera_frame_id");
    cameras.push_back(readCamera(root.group("camera"), "camera", std::move(frame)));
    checkIntrinsicsNamed(cameras.back(), root, "camera");
    return cameras;
  }
  if (root.has("camera") || root.has("camera_frame_id")) {
    root.addError("cameras",
                  "found together with camera or camera_frame_id; one camera is set by "
                  "those, several only by cameras");
    root.ignore("camera");
    root.ignore("camera_frame_id");
  }
  Parameters all = root.group("cameras");
  for (const std::string& name : folderNames(all)) {
    cameras.push_back(readCamera(all.group(name), name, std::nullopt));
    checkIntrinsicsNamed(cameras.back(), all, name);
  }
  if (all.names().empty()) {
    root.addError("cameras", "found no camera; it should be a group with a group for each camera");
  }
  if (cameras.empty()) cameras.emplace_back();  // the error is already noted
  return cameras;
}

}  // namespace synthetic_dataset::config
