#pragma once

#include <string>
#include <vector>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// A class as numbered by Cityscapes' tools.
struct CityscapesLabel {
  std::string name;   ///< of the label
  int id = 0;         ///< in the pictures
  int class_id = -1;  ///< of the dataset's class; -1 if it is not one
};

/// An object's part of `<image>_gtFine_polygons.json`.
struct CityscapesPolygon {
  std::string label;  ///< with "group" appended if single objects are not distinguished
  std::vector<cv::Point> points;
};

/// The names of cameras in the place of Cityscapes' cities; the tools split file names at each `_`.
[[nodiscard]] std::vector<std::string> cityNames(const std::vector<CameraDescription>& cameras);

/// The JSON that cityscapesscripts/helpers/annotation.py reads.
[[nodiscard]] std::string polygonsJson(const CameraModel& camera,
                                       const std::vector<CityscapesPolygon>& polygons);

/// Cityscapes' `_camera.json` (csCalibration.pdf): the intrinsics [px], and the pose of the camera
/// in a frame x ahead, y left, z up [m, rad], roll, pitch and yaw about its fixed x, y and z. That
/// frame is the vehicle's in Cityscapes and the global frame in this dataset. There is no second
/// camera, hence no baseline.
[[nodiscard]] std::string cameraJson(const Scene& scene);

}  // namespace synthetic_dataset
