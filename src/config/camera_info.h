#pragma once

#include <string>

#include "synthetic_dataset/camera_model.h"

namespace synthetic_dataset::config {

/// Reads a camera's calibration as `camera_calibration` writes it (image_width, camera_matrix:
/// {data}, ...; http://wiki.ros.org/camera_calibration_parsers) or as `rostopic echo` prints a
/// sensor_msgs/CameraInfo (width, K, ...).
/// @param rectified  take the rectified camera (the projection matrix, no distortion)
/// @throws ErrorList with all faults, each naming the file
[[nodiscard]] CameraModel readCameraInfo(const std::string& file, bool rectified, double near,
                                         double far);

}  // namespace synthetic_dataset::config
