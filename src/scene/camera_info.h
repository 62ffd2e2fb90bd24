#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::scene {

/// A calibration's numbers, by the names of sensor_msgs/CameraInfo.
struct CameraInfoNumbers {
  int width = 0;   ///< of the whole sensor [px]
  int height = 0;  ///< [px]
  std::string distortion_model = "plumb_bob";
  std::vector<double> D;
  std::array<double, 9> K{};                ///< row by row
  std::optional<std::array<double, 12>> P;  ///< row by row; needed for a rectified camera
  int binning_x = 0;                        ///< sensor pixels for one of the image; 0 means 1
  int binning_y = 0;
  int roi_x_offset = 0;  ///< of the part that is read out, in sensor pixels; a size of 0: all of it
  int roi_y_offset = 0;
  int roi_width = 0;
  int roi_height = 0;
};

/// The camera that a calibration describes, and whose images have its binning and region of
/// interest.
/// @param rectified  take the rectified camera (the projection matrix, no distortion)
/// @throws ErrorList with all faults, each naming the field
[[nodiscard]] CameraModel cameraModelFrom(const CameraInfoNumbers& numbers, bool rectified,
                                          double near, double far);

/// Takes a camera's calibration from a map with the names that `camera_calibration` writes
/// (image_width, camera_matrix: {data}, ...; http://wiki.ros.org/camera_calibration_parsers) or
/// those of sensor_msgs/CameraInfo (width, K, ...).
/// @param origin  where the map comes from
/// @throws ErrorList with all faults, each beginning with the origin
[[nodiscard]] CameraModel cameraModelOf(const Value& info, const std::string& origin,
                                        bool rectified, double near, double far);

/// cameraModelOf what is in a YAML file.
[[nodiscard]] CameraModel readCameraInfo(const std::string& file, bool rectified, double near,
                                         double far);

}  // namespace synthetic_dataset::scene
