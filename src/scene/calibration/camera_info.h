#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/pose.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::scene {

/// A calibration's numbers, named as in sensor_msgs/CameraInfo.
struct CameraInfoNumbers {
  int width = 0;   ///< of the whole sensor [px]
  int height = 0;  ///< [px]
  std::string distortion_model = "plumb_bob";
  std::vector<double> D;
  std::array<double, 9> K{};                ///< row by row
  std::optional<std::array<double, 9>> R;   ///< row by row; none: no rotation
  std::optional<std::array<double, 12>> P;  ///< row by row; needed for a rectified camera
  int binning_x = 0;                        ///< sensor pixels per image pixel; 0 means 1
  int binning_y = 0;
  int roi_x_offset = 0;  ///< of the part that is read out, in sensor pixels; size 0: all of it
  int roi_y_offset = 0;
  int roi_width = 0;
  int roi_height = 0;
};

/// How a calibration is used.
struct CalibrationUse {
  bool rectified = false;  ///< the rectified camera: rotation and projection matrix, no distortion
  double near = 0.05;      ///< [m]
  double far = 1000.0;     ///< [m]
};

/// The camera that a calibration describes.
struct CalibratedCamera {
  CameraModel model;

  /// Pose of the picture's frame in the optical frame that was calibrated. They differ for a
  /// rectified camera: it is rotated, and the second camera of a stereo pair is placed in the frame
  /// of the first.
  Pose X_FC = Pose::Identity();

  std::string frame = "";  ///< the optical frame's name; empty: not in the calibration
  std::vector<std::string> warnings = {};  ///< each naming its field
};

/// Makes a camera from the numbers; its images have their binning and region of interest.
/// @throws ErrorList with all faults, each naming the field
[[nodiscard]] CalibratedCamera cameraFrom(const CameraInfoNumbers& numbers,
                                          const CalibrationUse& use);

/// cameraFrom() for a map with the names that `camera_calibration` writes (image_width,
/// camera_matrix, ...; http://wiki.ros.org/camera_calibration_parsers) or those of
/// sensor_msgs/CameraInfo of ROS 1 or 2 (width, K or k, header, ...).
/// @param origin  where the map comes from, for messages
/// @throws ErrorList with all faults, each beginning with the origin
[[nodiscard]] CalibratedCamera cameraOf(const Value& info, const std::string& origin,
                                        const CalibrationUse& use);

}  // namespace synthetic_dataset::scene
