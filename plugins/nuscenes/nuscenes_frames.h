#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/box.h"
#include "synthetic_dataset/label_writer.h"

/// The data that the writer keeps from scenes for nuScenes' tables.
namespace synthetic_dataset::nuscenes {

using Quaternion = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;  ///< w, x, y, z

/// A pose in the form used by the tables.
struct Placement {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< [m]
  Quaternion rotation = Quaternion::Zero();
};

[[nodiscard]] Placement placementOf(const Pose& pose);

/// An object that is seen by a camera or hit by a lidar.
struct SeenObject {
  std::int64_t object = 0;                         ///< its index
  Placement X_GB;                                  ///< of its box
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< width, length, height [m]
  double visibility = 0.0;
  std::int64_t pixels = 0;
  std::int64_t points = 0;  ///< of the lidar
  Box box;                  ///< in coordinates in which the image spans 0 to its width [px]
};

/// The data of one camera, or of the lidar, at one instant.
struct Frame {
  std::int64_t scene = 0;  ///< Scene::index
  std::int64_t instant = 0;
  std::int64_t microseconds = 0;
  std::int64_t sequence = 0;
  std::int64_t camera = 0;  ///< camera index; the lidar's is one past the last camera's
  std::string file;
  Placement X_GE;  ///< of the ego frame E: the sensor's, x ahead, y left, z up
  std::vector<SeenObject> objects;
};

/// Whether the frame is the lidar's.
[[nodiscard]] bool isLidar(const DatasetInfo& dataset, const Frame& frame);

/// The token of the frame's sample_data.
[[nodiscard]] std::string dataToken(const DatasetInfo& dataset, const Frame& frame);

/// Converts a frame to a record, and back.
[[nodiscard]] std::string recordOf(const Frame& frame);
[[nodiscard]] Frame frameOf(std::int64_t scene, const std::string& record);

}  // namespace synthetic_dataset::nuscenes
