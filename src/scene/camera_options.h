#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "randomize/placement/placement_options.h"
#include "render/sensor/sensor_options.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::scene {

/// Selects a camera of a calibration file.
struct CalibrationChoice {
  std::optional<std::string> camera;  ///< its name in the file; optional if it has only one

  /// The camera of the same file whose optical frame the pose is given for: the file's extrinsics
  /// then place this camera relative to it.
  std::optional<std::string> reference;
};

/// When a camera's sensor gathers light. A picture's stamp is the middle of its exposure; with a
/// rolling shutter, the middle of the exposure of its middle row.
struct Shutter {
  Duration exposure_time{0};  ///< of each row; above 0, moving things are blurred
  int motion_samples = 8;     ///< pictures averaged over the exposure
  Duration readout_time{0};   ///< from the first row's exposure to the last row's
  int readout_bands = 24;     ///< bands of rows, each with its own lights and shadows
};

/// Where a camera stands, and which way it looks: given by angles, or by a target.
struct CameraAim {
  Eigen::Vector3d position_G{0, 0, 0};  ///< [m]; with `mounted_on`, in that object's frame

  /// Roll, pitch and yaw about the fixed axes x, y, z [rad], of the camera's body frame, which
  /// looks along x and has z up, as in SDF and URDF.
  std::optional<Eigen::Vector3d> rpy;
  std::optional<Eigen::Vector3d> look_at_point_G;  ///< instead of rpy; in the position's frame
  std::string look_at;  ///< instead of both: an object that it keeps looking at
};

/// The frame of the second camera of a rectified stereo pair.
enum class StereoFrame {
  kAuto,   ///< decided by where its frame is
  kFirst,  ///< the first camera's, as in ROS
  kOwn,    ///< its own, a baseline away from the first camera's
};

struct CameraOptions {
  std::string name = "camera";
  std::string group = "camera";                     ///< its parameters' full name, for messages
  std::optional<std::string> frame;                 ///< none: that of the recorded CameraInfo
  bool frame_is_given = true;                       ///< otherwise the calibration's, if it is in TF
  std::optional<std::string> info_file;             ///< absolute
  scene::CalibrationChoice info_choice;             ///< of the file's cameras
  std::optional<std::string> info_topic;            ///< of the bag
  std::optional<std::string> sensor;                ///< "model::link::sensor"
  std::optional<std::string> image_topic;           ///< of the bag: the camera's recorded pictures
  Duration time_offset{0};                          ///< added to its stamps to give TF's clock
  std::optional<Pose> X_GC;                         ///< with `mounted_on`, in that object's frame
  std::optional<CameraAim> aim;                     ///< instead of X_GC
  std::optional<std::string> on;                    ///< the object that it is mounted on
  std::optional<randomize::CameraSampling> sample;  ///< if set, drawn for each scene
  bool rectified = false;
  double focal_scale = 1.0;  ///< factor of both of the calibration's focal lengths
  std::optional<Pose> X_FD;  ///< of the true optical frame (D) in TF's one
  StereoFrame stereo_frame = StereoFrame::kAuto;
  std::optional<double> near;  ///< [m]; none: that of the world's `sensor`
  std::optional<double> far;   ///< [m]; none: that of the world's `sensor`
  Shutter shutter;
  render::SensorEffects effects;       ///< except for the noise
  std::optional<double> noise_mean;    ///< of the full scale; none: the world's sensor's
  std::optional<double> noise_stddev;  ///< of the full scale; none: the world's sensor's
  render::DepthNoise depth_noise;
};

}  // namespace synthetic_dataset::scene
