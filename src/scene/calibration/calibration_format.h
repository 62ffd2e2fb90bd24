#pragma once

#include <optional>
#include <string>
#include <vector>

#include "synthetic_dataset/pose.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::scene {

/// One of the cameras of a calibration file.
struct ListedCamera {
  std::string name;  ///< in the file; empty if the file is of a single camera
  Value::Map info;   ///< in the form that cameraOf() reads
  std::optional<Pose> X_BC = std::nullopt;  ///< in a frame shared by cameras of the file
};

/// A file format for calibrations. Each reader has a source file of its own, and is listed in
/// calibration_file.cpp.
struct CalibrationFormat {
  /// Whether a file's text is in this format.
  bool (*recognises)(const std::string& text);

  /// Its cameras; at least one.
  /// @param file  for messages
  /// @throws Error beginning with the file's name
  std::vector<ListedCamera> (*read)(const std::string& text, const std::string& file);
};

/// `[image]`, `[narrow_stereo]`, ...: camera_calibration's ost.txt, also called ost.ini.
extern const CalibrationFormat kOstFormat;

/// OpenCV's FileStorage, YAML or XML.
extern const CalibrationFormat kOpenCvFormat;

/// Kalibr's camchain.
extern const CalibrationFormat kKalibrFormat;

/// camodocal's and VINS-Mono's YAML, with `model_type` and `projection_parameters`.
extern const CalibrationFormat kCamodocalFormat;

/// YAML with ROS's names; recognises everything, so it has to come last.
extern const CalibrationFormat kRosFormat;

}  // namespace synthetic_dataset::scene
