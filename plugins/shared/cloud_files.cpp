#include "plugins/shared/cloud_files.h"

#include <cstring>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {

CloudPositions readCloudPositions(Parameters& parameters) {
  return parameters.optional("motion_corrected", true) ? CloudPositions::kAtStamp
                                                       : CloudPositions::kMeasured;
}

std::int64_t readMinPoints(Parameters& parameters) {
  return parameters.maybeBetween<std::int64_t>("min_points", 0, 1000000).value_or(0);
}

const Eigen::Vector3f& positionOf(const CloudPoint& point, CloudPositions positions) {
  return positions == CloudPositions::kAtStamp ? point.position_at_stamp_S : point.position_S;
}

void appendWord(std::string& bytes, std::uint32_t number) {
  for (unsigned shift = 0; shift < 32U; shift += 8U) {
    bytes.push_back(static_cast<char>(number >> shift & 0xFFU));
  }
}

void appendFloat(std::string& bytes, float number) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  appendWord(bytes, bits);
}

std::string velodyneFile(const Cloud& cloud, CloudPositions positions) {
  constexpr std::size_t kBytesOfAPoint = 16;
  std::string bytes;
  bytes.reserve(kBytesOfAPoint * cloud.points.size());
  for (const CloudPoint& point : cloud.points) {
    const Eigen::Vector3f& p = positionOf(point, positions);
    for (const float number : {p.x(), p.y(), p.z(), point.intensity}) appendFloat(bytes, number);
  }
  return bytes;
}

std::string matrixText(const Pose& pose) {
  constexpr int kDecimals = 9;
  std::string text;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      text += (text.empty() ? "" : " ") + fixed(pose.matrix()(row, column), kDecimals);
    }
  }
  return text;
}

}  // namespace synthetic_dataset
