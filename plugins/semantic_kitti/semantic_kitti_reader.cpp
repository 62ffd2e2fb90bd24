#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "plugins/readback/cloud_pictures.h"
#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "plugins/semantic_kitti/semantic_kitti_classes.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::semantic_kitti {
namespace {

namespace fs = std::filesystem;

/// The names of classes by number, from `semantic-kitti.yaml`; none before the dataset is complete.
struct ClassNames {
  explicit ClassNames(const fs::path& file) {
    if (!fs::exists(file)) return;
    bool is_in_list = false;
    for (const std::string& line : readLines(file)) {
      if (line.front() != ' ') {
        is_in_list = line == "labels:";
        continue;
      }
      const std::size_t colon = line.find(": \"");
      if (!is_in_list || colon == std::string::npos) continue;
      const double number = numberOf(line.substr(2, colon - 2), file);
      names[static_cast<std::uint16_t>(number)] =
          line.substr(colon + 3, line.rfind('"') - colon - 3);
    }
  }

  std::map<std::uint16_t, std::string> names;
};

/// @throws Error if there is not exactly one label for each point
LabelledCloud readCloud(const WrittenScene& scene) {
  const fs::path file = scene.file(".label");
  LabelledCloud cloud;
  if (const auto lidar = scene.settings.find("lidar"); lidar != scene.settings.end()) {
    cloud.lidar = lidar->second.text();
  }
  addVelodynePoints(cloud, scene.file(".bin"));
  const std::string labels = readText(file);
  if (labels.size() != 4 * cloud.points.size()) {
    throw Error("'" + file.string() + "': found " + std::to_string(labels.size()) +
                " bytes; it should have four for each of the cloud's " +
                std::to_string(cloud.points.size()) + " points");
  }
  const std::map<std::uint16_t, std::string> names =
      scene.kept->get<ClassNames>(scene.folder / "semantic-kitti.yaml")->names;
  cloud.has_labels = true;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const std::uint32_t label = wordAt(labels, 4 * i);
    LabelledCloud::Point& point = cloud.points[i];
    point.number = static_cast<std::uint16_t>(label & 0xFFFFU);
    point.object = static_cast<std::uint16_t>(label >> 16U);
    if (point.number == 0) continue;
    std::string& name = cloud.classes[point.number];
    const auto found = names.find(point.number);
    name = found != names.end() ? found->second : "class " + std::to_string(point.number);
    if (point.object == 0) continue;
    LabelledCloud::Object& object = cloud.objects[point.object];
    object.class_name = name;
    object.caption = name + " " + std::to_string(point.object);
  }
  return cloud;
}

std::vector<LabelledCloud> cloudsOf(const WrittenScene& scene) {
  if (scene.files.empty()) return {};
  return {readCloud(scene)};
}

/// The camera's image, if it was written, and the objects that have points: only these have labels.
LabelledPicture readScene(const WrittenScene& scene) {
  LabelledPicture picture;
  if (scene.files.empty()) return picture;
  for (const fs::path& file : scene.files) {
    if (file.extension() == ".png") picture.image = readPicture(file, cv::IMREAD_COLOR);
  }
  const LabelledCloud cloud = readCloud(scene);
  std::map<std::uint16_t, std::uint16_t> classes;  // by object
  for (const LabelledCloud::Point& point : cloud.points) classes[point.object] = point.number;
  for (const auto& [number, object] : cloud.objects) {
    DrawnLabel& label = picture.labels.emplace_back();
    label.caption = object.caption;
    label.class_names = {std::to_string(classes[number])};  // names exist only at the end
  }
  return picture;
}

/// The labels in the form used by the manifest; nothing if classes share a number.
std::optional<DecodedPicture> labelsPicture(const fs::path& file, std::size_t lidar,
                                            const SemanticKittiClasses& classes) {
  const std::string bytes = readText(file);
  if (bytes.size() % 4 != 0) throw Error("'" + file.string() + "': it ends within a label");
  constexpr std::uint16_t kNone = 0xFFFF;  // no class
  DecodedPicture picture;
  picture.name = picture.stored_as = "cloud_" + std::to_string(lidar) + "_labels";
  picture.files = {file};
  cv::Mat_<cv::Vec3w> labels(static_cast<int>(bytes.size() / 4), 1);
  for (int row = 0; row < labels.rows; ++row) {
    const std::uint32_t label = wordAt(bytes, 4 * static_cast<std::size_t>(row));
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

Format format() {
  return {"synthetic_dataset/SemanticKitti", false, readScene, picturesOf, cloudsOf};
}

}  // namespace synthetic_dataset::formats::semantic_kitti
