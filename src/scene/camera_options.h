#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "randomize/placement/placement_options.h"
#include "render/sensor/sensor_options.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::scene {

/// Which camera of a calibration file is meant.
struct CalibrationChoice {
  std::optional<std::string> camera;  ///< its name in the file; may be left out where it has one

  /// The camera of the same file whose optical frame the picture's pose is that of: the file's
  /// extrinsics then place this one against it.
  std::optional<std::string> reference;
};

/// When a camera's sensor gathers light. A picture's stamp is the middle of its exposure: of the
/// whole picture's, and with a rolling shutter of its middle row's.
struct Shutter {
  Duration exposure_time{0};  ///< of each row; above 0 what moves is blurred
  int motion_samples = 8;     ///< pictures that are averaged over it
  Duration readout_time{0};   ///< from the first row's exposure to the last row's
  int readout_bands = 24;     ///< of rows; each has lights and shadows of its own
};

/// Where a camera stands, and which way it looks: turned by angles, or at something.
struct CameraAim {
  Eigen::Vector3d position_G{0, 0, 0};  ///< [m]; with `mounted_on`, in that object's frame

  /// Roll, pitch and yaw about the fixed axes x, y, z of the camera as a body, which looks along
  /// its x and has z up, as in SDF and URDF [rad].
  std::optional<Eigen::Vector3d> rpy;
  std::optional<Eigen::Vector3d> look_at_point_G;  ///< instead; in the frame of the position
  std::string look_at;                             ///< instead of both: an object, which it follows
};

/// The frame of the second camera of a rectified stereo pair.
enum class StereoFrame {
  kAuto,   ///< found by where it is
  kFirst,  ///< the first camera's, as ROS has it
  kOwn,    ///< its own, which is a baseline away from the first camera's
};

struct CameraOptions {
  std::string name = "camera";
  std::string group = "camera";                     ///< its parameters' full name, for messages
  std::optional<std::string> frame;                 ///< none: that of the recorded CameraInfo
  bool frame_is_given = true;                       ///< else the calibration's, if it is in TF
  std::optional<std::string> info_file;             ///< absolute
  scene::CalibrationChoice info_choice;             ///< of the file's cameras
  std::optional<std::string> info_topic;            ///< of the bag
  std::optional<std::string> sensor;                ///< "model::link::sensor"
  std::optional<std::string> image_topic;           ///< of the bag: the pictures that it has taken
  Duration time_offset{0};                          ///< what its stamps lack to TF's clock
  std::optional<Pose> X_GC;                         ///< with `mounted_on`, in that object's frame
  std::optional<CameraAim> aim;                     ///< instead of X_GC
  std::optional<std::string> on;                    ///< the object that it is mounted on
  std::optional<randomize::CameraSampling> sample;  ///< drawn for each scene instead
  bool rectified = false;
  double focal_scale = 1.0;  ///< factor of both of the calibration's focal lengths
  std::optional<Pose> X_FD;  ///< of the true optical frame (D) in the one that TF has
  StereoFrame stereo_frame = StereoFrame::kAuto;
  std::optional<double> near;  ///< [m]; none: as the world has it of its `sensor`
  std::optional<double> far;   ///< [m]; none: as the world has it of its `sensor`
  Shutter shutter;
  render::SensorEffects effects;       ///< but for the noise
  std::optional<double> noise_mean;    ///< of the full scale; none: as the world's sensor says
  std::optional<double> noise_stddev;  ///< of the full scale; none: as the world's sensor says
  render::DepthNoise depth_noise;
};

}  // namespace synthetic_dataset::scene
