#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "synthetic_dataset/cloud.h"
#include "synthetic_dataset/label_writer.h"

/// Shared by formats with clouds.
namespace synthetic_dataset {

/// The positions used for a cloud's points.
enum class CloudPositions {
  kAtStamp,   ///< as if the scanner had stood still, as in motion-corrected recordings
  kMeasured,  ///< as measured by the moving scanner
};

/// Reads `motion_corrected`: whether the scanner's own motion is removed from the points.
[[nodiscard]] CloudPositions readCloudPositions(Parameters& parameters);

/// Reads `min_points`: how many lidar points an object needs for a label.
[[nodiscard]] std::int64_t readMinPoints(Parameters& parameters);

[[nodiscard]] const Eigen::Vector3f& positionOf(const CloudPoint& point, CloudPositions positions);

/// Appends a number as four bytes, little-endian.
void appendFloat(std::string& bytes, float number);
void appendWord(std::string& bytes, std::uint32_t number);

/// A file of KITTI's `velodyne`: x, y, z [m] and the intensity, 0 .. 1, four numbers of four bytes
/// per point.
[[nodiscard]] std::string velodyneFile(const Cloud& cloud, CloudPositions positions);

/// A pose's upper 3x4 matrix, row by row, as in KITTI's files.
[[nodiscard]] std::string matrixText(const Pose& pose);

}  // namespace synthetic_dataset
