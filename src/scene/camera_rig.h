#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "motion/frame_source.h"
#include "render/sensor/sensor_effects.h"
#include "render/weather/lens_dust.h"
#include "render/weather/weather.h"
#include "scene/camera_options.h"
#include "scene/object_options.h"
#include "scene/shutter.h"
#include "synthetic_dataset/camera_model.h"
#include "world/description.h"
#include "world/world.h"

namespace synthetic_dataset::scene {

/// What a camera looks at, wherever it goes.
struct FollowedObject {
  std::size_t object = 0;  ///< among the objects
  motion::FrameId frame = motion::kNoFrame;
  std::vector<Eigen::Vector3d> centres_O = {};  ///< of its variants; none: its frame's origin
};

/// A camera of the run: what it sees with, and where it is at a time.
struct CameraRig {
  std::string name;
  CameraModel model;
  std::string frame;                        ///< that says where it is, as far as it has a name
  std::optional<Pose> X_GC = std::nullopt;  ///< where it stands; none: it moves
  std::optional<std::size_t> link =
      std::nullopt;  ///< of the world's links, on which it rides at X_LC
  Pose X_LC = Pose::Identity();
  motion::FrameId followed = motion::kNoFrame;  ///< its own frame, or that of its carrier
  bool is_carried = false;   ///< it rides at X_LC on an object or a frame, which it follows
  std::string carrier = "";  ///< that frame, where it is no object's
  /// What it looks at from X_LC's position, in the global frame or on its carrier.
  std::optional<FollowedObject> looks_at = std::nullopt;
  bool sampled = false;  ///< its frame is placed for each scene

  /// Correction: pose of the true optical frame in the one that the sources have.
  std::optional<Pose> X_FD = std::nullopt;

  /// Pose of the picture's optical frame (C) in `frame`, for a rectified camera, which is turned,
  /// and for the second one of a stereo pair, which has its place in the frame of the first.
  Pose X_FC = Pose::Identity();
  std::string optical_frame = frame;  ///< of the picture: `frame`, unless X_FC moves it
  bool is_rectified = false;
  StereoFrame stereo_frame = StereoFrame::kAuto;
  Shutter shutter = {};
  render::SensorEffects effects = {};
  render::Weather weather = {};  ///< before it
  render::LensDust dust = {};    ///< on its glass
  render::DepthNoise depth_noise = {};

  /// Whether its pose is that of its own frame, which the source of motion has.
  [[nodiscard]] bool followsFrame() const {
    return !X_GC && !link && !is_carried && !looks_at && !sampled;
  }

  /// The frame that has to be known at the times of its scenes; empty: none but the objects'.
  [[nodiscard]] std::string neededFrame() const { return followsFrame() ? frame : carrier; }
};

/// Finds the intrinsics (a calibration file, a recorded CameraInfo, else the world's sensor) and
/// the pose (drawn, the parameter, else that of its frame, else the link that the world's sensor
/// is on).
/// @param sensors  the cameras of the world and of the objects' models
/// @param diagnostics  what the user should know of the calibration
/// @throws ErrorList naming the parameters that would mend it
[[nodiscard]] CameraRig makeCameraRig(const CameraOptions& config,
                                      const std::vector<std::string>& bag_files,
                                      const std::vector<world::CameraSensor>& sensors,
                                      const std::vector<world::LinkInstance>& links,
                                      const std::vector<ObjectOptions>& objects,
                                      const motion::FrameSource& frames,
                                      base::Diagnostics& diagnostics);

/// Reads the calibration that a camera's file has, if it names one.
/// @throws ErrorList with what is wrong with it
void checkInfoFile(const CameraOptions& config);

/// The share of the image's pixels along which the lens sees something, 0 .. 1: less than all in
/// the corners of a fisheye's image, and nearly none where a calibration's numbers are wrong.
[[nodiscard]] double seenShare(const CameraModel& camera);

/// The same camera with other focal lengths.
[[nodiscard]] CameraModel withFocalScale(const CameraModel& camera, double scale);

}  // namespace synthetic_dataset::scene
