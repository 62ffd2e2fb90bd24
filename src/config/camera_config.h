#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/camera_sampling.h"
#include "synthetic_dataset/parameters.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::config {

/// What a real sensor does to its picture; nothing of it by default.
struct EffectsConfig {
  double exposure = 0.0;               ///< [stops]
  double exposure_time = 0.0;          ///< [s] of motion blur
  int motion_samples = 8;              ///< pictures that are averaged over the exposure time
  double readout_time = 0.0;           ///< [s] from the first row to the last: rolling shutter
  int readout_bands = 24;              ///< rows are taken in so many groups
  double blur = 0.0;                   ///< standard deviation [px]
  double vignetting = 0.0;             ///< 0 .. 1: the light that the image's corner lacks
  double full_well = 0.0;              ///< electrons of a white pixel; 0: no shot noise
  std::optional<double> noise_mean;    ///< of the full scale; none: as the world's sensor says
  std::optional<double> noise_stddev;  ///< of the full scale; none: as the world's sensor says
};

struct CameraConfig {
  std::string name = "camera";
  std::string group = "camera";           ///< its parameters' full name, for messages
  std::optional<std::string> frame;       ///< none: that of the recorded CameraInfo
  std::optional<std::string> info_file;   ///< absolute
  std::optional<std::string> info_topic;  ///< of the bag
  std::optional<std::string> sensor;      ///< "model::link::sensor"
  std::optional<Pose> X_GC;               ///< with `mounted_on`, in that object's frame
  std::optional<std::string> on;          ///< the object that it is mounted on
  std::optional<CameraSampling> sample;   ///< drawn for each scene instead
  bool rectified = false;
  std::optional<double> near;  ///< [m]; none: as the world has it of its `sensor`
  std::optional<double> far;   ///< [m]; none: as the world has it of its `sensor`
  EffectsConfig effects;
};

/// The camera of the group `camera`, or those of the group `cameras`, in alphabetical order.
/// What is wrong is noted in `root`, with a harmless value in its place.
[[nodiscard]] std::vector<CameraConfig> readCameras(Parameters root);

}  // namespace synthetic_dataset::config
