#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "synthetic_dataset/cloud.h"
#include "synthetic_dataset/label_writer.h"

/// What formats with clouds share.
namespace synthetic_dataset {

/// Where a cloud's points are.
enum class CloudPositions {
  kAtStamp,   ///< as if the scanner had stood still: recordings that are corrected for its motion
  kMeasured,  ///< as it has measured them on its way
};

/// Reads `motion_corrected`: whether points are where they are without the scanner's own motion.
[[nodiscard]] CloudPositions readCloudPositions(Parameters& parameters);

/// Reads `min_points`: how many points of the lidar an object needs for a label.
[[nodiscard]] std::int64_t readMinPoints(Parameters& parameters);

[[nodiscard]] const Eigen::Vector3f& positionOf(const CloudPoint& point, CloudPositions positions);

/// Appends a number as binary files have it: four bytes, the lowest first.
void appendFloat(std::string& bytes, float number);
void appendWord(std::string& bytes, std::uint32_t number);

/// KITTI's velodyne: x, y, z [m] and the intensity, 0 .. 1, four numbers of four bytes a point.
[[nodiscard]] std::string velodyneFile(const Cloud& cloud, CloudPositions positions);

/// The rows of a pose's upper 3x4 matrix one after another, as KITTI's files have them.
[[nodiscard]] std::string matrixText(const Pose& pose);

}  // namespace synthetic_dataset
