#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "plugins/kitti/kitti_labels.h"
#include "plugins/readback/cloud_pictures.h"
#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "plugins/readback/kitti_files.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::kitti {
namespace {

namespace fs = std::filesystem;

LabelledPicture readScene(const WrittenScene& scene) {
  const fs::path image = scene.file(".png");
  const fs::path training = image.parent_path().parent_path();
  const std::string name = image.stem().string() + ".txt";
  const fs::path file = training / "label_2" / name;
  const Intrinsics camera = readKittiCamera(training / "calib" / name);
  LabelledPicture picture{readPicture(image, cv::IMREAD_COLOR), {}};
  for (const std::string& line : readLines(file)) {
    const auto words = wordsOf(line);
    if (words.size() != 15) throw Error("'" + file.string() + "': found the line '" + line + "'");
    picture.labels.push_back(kittiLabel(words, camera, file));
  }
  return picture;
}

/// x ahead, y left, z up [m], and a reflectance.
std::array<float, 4> pointAt(const std::string& bytes, std::size_t at) {
  std::array<float, 4> point{};
  std::memcpy(point.data(), bytes.data() + at, sizeof point);
  return point;
}

/// Reconstructs the depth image from a scan that has a point for each pixel with a depth, row by
/// row.
DecodedPicture depthOf(const fs::path& scan, const CameraModel& camera) {
  constexpr double kTolerance = 0.01;        // [px]
  constexpr double kSinglePrecision = 1e-5;  // [m], error of a depth from single precision
  DecodedPicture picture;
  picture.name = "depth";
  picture.numbers.rounding = kSinglePrecision;
  picture.files = {scan};
  cv::Mat depth(camera.height(), camera.width(), CV_32FC1, cv::Scalar(0));
  const std::string bytes = readText(scan);
  constexpr std::size_t kBytesOfAPoint = 4 * sizeof(float);
  if (bytes.size() % kBytesOfAPoint != 0) {
    throw Error("'" + scan.string() + "': it ends within a point");
  }
  int next = 0;  // pixel, row by row
  for (std::size_t at = 0; at < bytes.size(); at += kBytesOfAPoint) {
    const auto [x, y, z, reflectance] = pointAt(bytes, at);
    const auto pixel = camera.project({-y, -z, x});
    const int u = pixel ? static_cast<int>(std::lround(pixel->x())) : -1;
    const int v = pixel ? static_cast<int>(std::lround(pixel->y())) : -1;
    const bool is_at_centre =
        pixel && std::abs(pixel->x() - u) <= kTolerance && std::abs(pixel->y() - v) <= kTolerance;
    const bool is_in_image = u >= 0 && v >= 0 && u < depth.cols && v < depth.rows;
    if (!is_at_centre || !is_in_image || v * depth.cols + u < next || reflectance != 0.0F) {
      throw Error("'" + scan.string() + "': point " + std::to_string(at / kBytesOfAPoint) +
                  " is not that of the next pixel's centre, with a reflectance of 0");
    }
    const double range = std::sqrt(double{x} * x + double{y} * y + double{z} * z);
    depth.at<float>(v, u) =
        static_cast<float>(x * (1.0 - synthetic_dataset::kitti::kScanDepth / range));
    next = v * depth.cols + u + 1;
  }
  picture.stored = picture.pixels = depth;
  return picture;
}

std::vector<DecodedPicture> picturesOf(const WrittenScene& scene, const CameraModel& camera,
                                       const DatasetInfo& dataset) {
  std::vector<DecodedPicture> pictures;
  const auto name = kittiLidar(scene);
  const auto lidar = name ? lidarNamed(*name, dataset) : std::nullopt;
  for (const fs::path& file : scene.files) {
    if (file.extension() != ".bin") continue;
    pictures.push_back(lidar ? velodynePicture(file, *lidar, scene.settings)
                             : depthOf(file, camera));
  }
  return pictures;
}

std::vector<LabelledCloud> cloudsOf(const WrittenScene& scene) {
  if (!kittiLidar(scene)) return {};
  const fs::path scan = scene.file(".bin");
  const fs::path training = scan.parent_path().parent_path();
  const std::string name = scan.stem().string() + ".txt";
  const fs::path labels = training / "label_2" / name;
  std::vector<std::vector<std::string>> lines;
  for (const std::string& line : readLines(labels)) lines.push_back(wordsOf(line));
  return {kittiCloud(scene, lines, labels, training / "calib" / name)};
}

}  // namespace

Format format() { return {"synthetic_dataset/Kitti", false, readScene, picturesOf, cloudsOf}; }

}  // namespace synthetic_dataset::formats::kitti
