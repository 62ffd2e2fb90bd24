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

/// An object that a camera keeps looking at.
struct FollowedObject {
  std::size_t object = 0;  ///< index among the objects
  motion::FrameId frame = motion::kNoFrame;
  std::vector<Eigen::Vector3d> centres_O = {};  ///< of its variants; empty: its frame's origin
};

/// A camera of the run: its optics, and what determines its pose at a given time.
struct CameraRig {
  std::string name;
  CameraModel model;
  std::string frame;                        ///< that gives its pose, if there is a named one
  std::optional<Pose> X_GC = std::nullopt;  ///< its fixed pose; none: it moves
  std::optional<std::size_t> link =
      std::nullopt;  ///< the world's link on which it is mounted at X_LC
  Pose X_LC = Pose::Identity();
  motion::FrameId followed = motion::kNoFrame;  ///< its own frame, or its carrier's
  bool is_carried = false;   ///< mounted at X_LC on an object or frame that it follows
  std::string carrier = "";  ///< that frame, if it is not an object's
  /// What it looks at from X_LC's position, which is in the global frame or in its carrier's.
  std::optional<FollowedObject> looks_at = std::nullopt;
  bool sampled = false;  ///< its frame is placed for each scene

  /// Correction: pose of the true optical frame in the one that the sources give.
  std::optional<Pose> X_FD = std::nullopt;

  /// Pose of the picture's optical frame (C) in `frame`: for a rectified camera, which is rotated,
  /// and for the second camera of a stereo pair, which is placed in the frame of the first.
  Pose X_FC = Pose::Identity();
  std::string optical_frame = frame;  ///< of the picture: `frame`, unless X_FC moves it
  bool is_rectified = false;
  StereoFrame stereo_frame = StereoFrame::kAuto;
  Shutter shutter = {};
  render::SensorEffects effects = {};
  render::Weather weather = {};  ///< in front of it
  render::LensDust dust = {};    ///< on its lens
  render::DepthNoise depth_noise = {};

  /// Whether its pose is that of its own frame, from the source of motion.
  [[nodiscard]] bool followsFrame() const {
    return !X_GC && !link && !is_carried && !looks_at && !sampled;
  }

  /// The frame that has to be known at the times of its scenes; empty: only the objects' frames.
  [[nodiscard]] std::string neededFrame() const { return followsFrame() ? frame : carrier; }
};

/// Finds the intrinsics (from a calibration file, a recorded CameraInfo, or else the world's
/// sensor) and the pose (drawn, from the parameter, or else that of its frame, or else from the
/// link that the world's sensor is on).
/// @param sensors  the cameras of the world and of the objects' models
/// @param diagnostics  receives what the user should know about the calibration
/// @throws ErrorList naming the parameters that would fix it
[[nodiscard]] CameraRig makeCameraRig(const CameraOptions& config,
                                      const std::vector<std::string>& bag_files,
                                      const std::vector<world::CameraSensor>& sensors,
                                      const std::vector<world::LinkInstance>& links,
                                      const std::vector<ObjectOptions>& objects,
                                      const motion::FrameSource& frames,
                                      base::Diagnostics& diagnostics);

/// Checks the calibration in a camera's info_file, if it has one.
/// @throws ErrorList with what is wrong with it
void checkInfoFile(const CameraOptions& config);

/// The fraction of the image's pixels that the lens maps to a ray, 0 .. 1: below 1 for a fisheye,
/// whose image has black corners, and close to 0 if a calibration's numbers are wrong.
[[nodiscard]] double seenShare(const CameraModel& camera);

/// The same camera with other focal lengths.
[[nodiscard]] CameraModel withFocalScale(const CameraModel& camera, double scale);

}  // namespace synthetic_dataset::scene
