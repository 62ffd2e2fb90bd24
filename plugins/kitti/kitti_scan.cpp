#include "plugins/kitti/kitti_scan.h"

#include <array>
#include <cmath>
#include <cstring>

#include <opencv2/core.hpp>

#include "plugins/readback/depth_values.h"
#include "plugins/readback/files.h"

namespace synthetic_dataset::formats::kitti {
namespace {

constexpr std::size_t kBytesOfAPoint = 4 * sizeof(float);

/// x ahead, y left, z up [m], and a reflectance.
std::array<float, 4> pointAt(const std::string& bytes, std::size_t index) {
  std::array<float, 4> point{};
  std::memcpy(point.data(), bytes.data() + index * kBytesOfAPoint, kBytesOfAPoint);
  return point;
}

}  // namespace

void compareScan(const std::string& name, const TrueScene& truth, FoundFiles& files) {
  constexpr double kTolerance = 0.01;  // [px]
  const auto file = files.take(name);
  if (!file) return;
  const std::string bytes = readText(*file);
  if (bytes.size() % kBytesOfAPoint != 0) {
    files.differences().add(name + ": it ends within a point");
    return;
  }
  const CameraModel& camera = truth.scene.camera;
  cv::Mat depth(camera.height(), camera.width(), CV_32FC1, cv::Scalar(0));
  int next = 0;  // pixel, row by row
  for (std::size_t i = 0; i < bytes.size() / kBytesOfAPoint; ++i) {
    const auto [x, y, z, reflectance] = pointAt(bytes, i);
    const auto pixel = camera.project({-y, -z, x});
    const int u = pixel ? static_cast<int>(std::lround(pixel->x())) : -1;
    const int v = pixel ? static_cast<int>(std::lround(pixel->y())) : -1;
    const bool is_at_centre =
        pixel && std::abs(pixel->x() - u) <= kTolerance && std::abs(pixel->y() - v) <= kTolerance;
    const bool is_in_image = u >= 0 && v >= 0 && u < depth.cols && v < depth.rows;
    if (!is_at_centre || !is_in_image || v * depth.cols + u < next || reflectance != 0.0F) {
      files.differences().add(name + ": point " + std::to_string(i) +
                              " is not that of the next pixel's centre, with a reflectance of 0");
      return;
    }
    depth.at<float>(v, u) = x;
    next = v * depth.cols + u + 1;
  }
  if (camera.isPinhole()) {
    files.comparePixels(name, depth, truth, "depth");
    return;
  }
  constexpr double kSinglePrecision = 1e-5;  // [m], that a ray's length may cost of a depth
  const std::string problem = depthProblem(depth, {1.0, kSinglePrecision}, truth.depth_cells);
  if (!problem.empty()) files.differences().add(name + ": " + problem);
}

}  // namespace synthetic_dataset::formats::kitti
