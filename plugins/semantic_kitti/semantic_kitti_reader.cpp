#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>

#include "plugins/readback/cloud_pictures.h"
#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "plugins/semantic_kitti/semantic_kitti_classes.h"
#include "plugins/shared/colour_map.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::semantic_kitti {
namespace {

namespace fs = std::filesystem;

struct LabelledPoint {
  float x = 0.0F;  ///< ahead [m]
  float y = 0.0F;  ///< to the left [m]
  std::uint32_t class_number = 0;
  std::uint32_t instance = 0;
};

std::uint32_t wordAt(const std::string& bytes, std::size_t word) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + 4 * word, sizeof value);
  return value;
}

float numberAt(const std::string& bytes, std::size_t word) {
  float value = 0.0F;
  std::memcpy(&value, bytes.data() + 4 * word, sizeof value);
  return value;
}

/// @throws Error where there is not a label for each point
std::vector<LabelledPoint> readPoints(const fs::path& cloud, const fs::path& labels) {
  constexpr std::size_t kBytesOfAPoint = 16;
  const std::string of_cloud = readText(cloud);
  const std::string of_labels = readText(labels);
  const std::size_t count = of_cloud.size() / kBytesOfAPoint;
  if (of_cloud.size() % kBytesOfAPoint != 0 || of_labels.size() != 4 * count) {
    throw Error("'" + labels.string() + "': found " + std::to_string(of_labels.size()) +
                " bytes; it should have four for each point of '" + cloud.string() +
                "', which has " + std::to_string(of_cloud.size()) + " bytes");
  }
  std::vector<LabelledPoint> points;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t label = wordAt(of_labels, i);
    points.push_back(
        {numberAt(of_cloud, 4 * i), numberAt(of_cloud, 4 * i + 1), label & 0xFFFFU, label >> 16U});
  }
  return points;
}

/// The cloud seen from above, the scanner in the middle, x to the right and y upwards, coloured by
/// classes; around the points of each object a box.
LabelledPicture seenFromAbove(const std::vector<LabelledPoint>& points) {
  constexpr int kSize = 800;       // [px]
  constexpr double kShown = 0.98;  // of all points
  std::vector<float> distances;
  for (const LabelledPoint& p : points) distances.push_back(std::hypot(p.x, p.y));
  std::sort(distances.begin(), distances.end());
  const double reach =
      distances.empty()
          ? 1.0
          : distances[static_cast<std::size_t>(kShown * static_cast<double>(distances.size() - 1))];
  const double scale = 0.48 * kSize / std::max(reach, 1.0);
  const std::vector<cv::Vec3b> colours = vocColourMap();
  LabelledPicture picture{cv::Mat(kSize, kSize, CV_8UC3, cv::Scalar::all(0)), {}};
  std::map<std::uint32_t, DrawnLabel> objects;
  for (const LabelledPoint& p : points) {
    const double u = 0.5 * kSize + scale * p.x;
    const double v = 0.5 * kSize - scale * p.y;
    if (!(u >= 0.0 && v >= 0.0 && u < kSize && v < kSize)) continue;
    const cv::Vec3b colour =
        p.class_number == 0 ? cv::Vec3b(96, 96, 96) : colours[p.class_number % colours.size()];
    picture.image.at<cv::Vec3b>(static_cast<int>(v), static_cast<int>(u)) = colour;
    if (p.instance == 0) continue;
    DrawnLabel& label = objects[p.instance];
    label.caption = std::to_string(p.class_number) + " #" + std::to_string(p.instance);
    label.class_names = {std::to_string(p.class_number)};
    if (!label.box) label.box = Box{u, v, u, v};
    label.box = Box{std::min(label.box->left, u), std::min(label.box->top, v),
                    std::max(label.box->right, u), std::max(label.box->bottom, v)};
  }
  for (const auto& [instance, label] : objects) picture.labels.push_back(label);
  return picture;
}

LabelledPicture readScene(const WrittenScene& scene) {
  if (scene.files.empty()) return {cv::Mat(1, 1, CV_8UC3, cv::Scalar::all(0)), {}};
  return seenFromAbove(readPoints(scene.file(".bin"), scene.file(".label")));
}

/// The labels as the manifest knows them; nothing where classes share a number.
std::optional<DecodedPicture> labelsPicture(const fs::path& file, std::size_t lidar,
                                            const SemanticKittiClasses& classes) {
  const std::string bytes = readText(file);
  if (bytes.size() % 4 != 0) throw Error("'" + file.string() + "': it ends within a label");
  constexpr std::uint16_t kNone = 0xFFFF;  // of no class
  DecodedPicture picture;
  picture.name = picture.stored_as = "cloud_" + std::to_string(lidar) + "_labels";
  picture.files = {file};
  cv::Mat_<cv::Vec3w> labels(static_cast<int>(bytes.size() / 4), 1);
  for (int row = 0; row < labels.rows; ++row) {
    const std::uint32_t label = wordAt(bytes, static_cast<std::size_t>(row));
    const std::uint32_t number = label & 0xFFFFU;
    auto meaning = classes.meaningOf(number);
    if (classes.names().count(number) == 0) meaning = SemanticKittiClasses::Meaning{kNone, kNone};
    if (!meaning) return std::nullopt;
    labels(row) = {static_cast<std::uint16_t>(label >> 16U), meaning->class_number,
                   meaning->world_class};
  }
  picture.stored = labels;
  return picture;
}

std::vector<DecodedPicture> picturesOf(const WrittenScene& scene, const CameraModel& /*camera*/,
                                       const DatasetInfo& dataset) {
  if (scene.files.empty() || dataset.lidars.empty()) return {};
  const auto named = scene.settings.find("lidar");
  const auto lidar = named == scene.settings.end() ? std::optional<std::size_t>(0)
                                                   : lidarNamed(named->second.text(), dataset);
  if (!lidar) return {};
  Parameters settings{Value(scene.settings)};
  const SemanticKittiClasses classes(settings, dataset);
  std::vector<DecodedPicture> pictures = {
      velodynePicture(scene.file(".bin"), *lidar, scene.settings)};
  if (auto labels = labelsPicture(scene.file(".label"), *lidar, classes)) {
    pictures.push_back(std::move(*labels));
  }
  return pictures;
}

}  // namespace

Format format() { return {"synthetic_dataset/SemanticKitti", false, readScene, picturesOf}; }

}  // namespace synthetic_dataset::formats::semantic_kitti
