#pragma once

#include <string>

#include "scene/calibration/camera_info.h"
#include "scene/camera_options.h"

namespace synthetic_dataset::scene {

/// Reads a calibration in any of the known formats: camera_info YAML as written by
/// camera_calibration, CameraInfo as printed by `rostopic echo` and `ros2 topic echo`,
/// camera_calibration's ost.txt, a Kalibr camchain, camodocal's YAML, or OpenCV's FileStorage (YAML
/// or XML).
/// @throws ErrorList with all faults, each beginning with the file's name
[[nodiscard]] CalibratedCamera readCalibration(const std::string& file,
                                               const CalibrationChoice& choice,
                                               const CalibrationUse& use);

/// The same for a file's text.
/// @param file  for messages
[[nodiscard]] CalibratedCamera parseCalibration(const std::string& text, const std::string& file,
                                                const CalibrationChoice& choice,
                                                const CalibrationUse& use);

}  // namespace synthetic_dataset::scene
