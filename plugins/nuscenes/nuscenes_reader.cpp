#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>

#include <Eigen/Geometry>
#include <opencv2/imgcodecs.hpp>

#include "plugins/nuscenes/nuscenes_index.h"
#include "plugins/nuscenes/nuscenes_options.h"
#include "plugins/readback/camera_drawing.h"
#include "plugins/readback/files.h"
#include "plugins/readback/format.h"
#include "plugins/readback/json_file.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::nuscenes {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

Eigen::Vector3d vectorOf(const json& numbers) {
  const auto [x, y, z] = numbers.get<std::array<double, 3>>();
  return {x, y, z};
}

Pose poseOf(const json& record) {
  const auto [w, x, y, z] = record.at("rotation").get<std::array<double, 4>>();
  return makePose(vectorOf(record.at("translation")), Eigen::Quaterniond(w, x, y, z).normalized());
}

/// The corners of an annotation's box, as computed by Box.corners() of the devkit's
/// utils/data_classes.py, but in the order of Cuboid::corners().
std::array<Eigen::Vector3d, 8> cornersOf(const json& annotation, const Pose& X_CG) {
  const Eigen::Vector3d wlh = vectorOf(annotation.at("size"));
  const Pose X_CB = X_CG * poseOf(annotation);
  std::array<Eigen::Vector3d, 8> corners;
  for (unsigned i = 0; i < 8; ++i) {
    corners[i] = X_CB * Eigen::Vector3d(((i & 4U) != 0 ? 0.5 : -0.5) * wlh.y(),
                                        ((i & 2U) != 0 ? 0.5 : -0.5) * wlh.x(),
                                        ((i & 1U) != 0 ? 0.5 : -0.5) * wlh.z());
  }
  return corners;
}

/// The tables that contain an image's labels.
class Tables {
 public:
  explicit Tables(const WrittenScene& scene) : scene_(scene) {
    const auto version = scene.settings.find("version");
    folder_ = scene.folder / (version == scene.settings.end() ? NuScenesOptions().version
                                                              : version->second.text());
  }

  [[nodiscard]] const json& record(const char* table, const json& token) const {
    return scene_.kept->get<TokenTable>(folder_ / (std::string(table) + ".json"))
        ->at(token.get<std::string>());
  }

  [[nodiscard]] std::vector<json> labelsOf(const std::string& image) const {
    return scene_.kept->get<RecordsByFile>(folder_ / "image_annotations.json")->of(image);
  }

  /// The sample_data record of a file.
  [[nodiscard]] json dataOf(const std::string& file) const {
    const auto found = scene_.kept->get<RecordsByFile>(folder_ / "sample_data.json")->of(file);
    if (found.empty()) {
      throw Error("'" + (folder_ / "sample_data.json").string() + "': no record is of '" + file +
                  "'");
    }
    return found.front();
  }

  [[nodiscard]] std::vector<json> annotationsOf(const json& sample_token) const {
    return scene_.kept->get<RecordsBySample>(folder_ / "sample_annotation.json")
        ->of(sample_token.get<std::string>());
  }

  [[nodiscard]] const fs::path& folder() const { return folder_; }

 private:
  const WrittenScene& scene_;
  fs::path folder_;
};

DrawnLabel labelOf(const json& seen, const Tables& tables) {
  DrawnLabel label;
  label.caption = seen.at("category_name").get<std::string>();
  label.class_names = {label.caption};
  const auto [left, top, right, bottom] = seen.at("bbox_corners").get<std::array<double, 4>>();
  label.box = Box{left - 0.5, top - 0.5, right - 0.5, bottom - 0.5};
  const json& data = tables.record("sample_data", seen.at("sample_data_token"));
  const json& sensor = tables.record("calibrated_sensor", data.at("calibrated_sensor_token"));
  const json& ego = tables.record("ego_pose", data.at("ego_pose_token"));
  const json& k = sensor.at("camera_intrinsic");
  const Intrinsics camera{k.at(0).at(0).get<double>(), k.at(1).at(1).get<double>(),
                          k.at(0).at(2).get<double>(), k.at(1).at(2).get<double>()};
  const Pose X_CG = (poseOf(ego) * poseOf(sensor)).inverse();
  const json& annotation = tables.record("sample_annotation", seen.at("sample_annotation_token"));
  addCuboid(label, camera, cornersOf(annotation, X_CG));
  return label;
}

LabelledPicture readScene(const WrittenScene& scene) {
  if (scene.files.empty()) throw Error("'" + scene.folder.string() + "': no image of the scene");
  const auto isImage = [](const fs::path& file) { return file.extension() != ".bin"; };
  const auto found = std::find_if(scene.files.begin(), scene.files.end(), isImage);
  if (found == scene.files.end()) throw Error("'" + scene.folder.string() + "': no image");
  const fs::path& image = *found;
  const Tables tables(scene);
  LabelledPicture picture{readPicture(image, cv::IMREAD_COLOR), {}};
  readingJson(tables.folder() / "image_annotations.json", [&] {
    for (const json& each : tables.labelsOf(image.lexically_relative(scene.folder).string())) {
      picture.labels.push_back(labelOf(each, tables));
    }
  });
  return picture;
}

/// The names of categories by their numbers in lidarseg, except 0, noise.
struct CategoryNames {
  explicit CategoryNames(const fs::path& file) {
    readJson(file, [&](const json& table) {
      for (const json& each : table) {
        if (each.count("index") == 0) continue;
        const auto number = integerOf<std::uint16_t>(each.at("index"));
        if (number != 0) names[number] = each.at("name").get<std::string>();
      }
    });
  }

  std::map<std::uint16_t, std::string> names;
};

/// Adds the points in the ego frame, which is the scanner's with x ahead.
void addPoints(LabelledCloud& cloud, const fs::path& file, const Pose& X_EN) {
  constexpr std::size_t kBytesOfAPoint = 20;
  const std::string bytes = readText(file);
  if (bytes.size() % kBytesOfAPoint != 0) {
    throw Error("'" + file.string() + "': it ends within a point");
  }
  cloud.has_rings = true;
  for (std::size_t at = 0; at < bytes.size(); at += kBytesOfAPoint) {
    const Eigen::Vector3d p_N(floatAt(bytes, at), floatAt(bytes, at + 4), floatAt(bytes, at + 8));
    LabelledCloud::Point& point = cloud.points.emplace_back();
    point.position_S = (X_EN * p_N).cast<float>();
    const float ring = floatAt(bytes, at + 16);
    constexpr float kMostRings = 65535.0F;
    if (!(ring >= 0.0F && ring <= kMostRings)) {
      throw Error("'" + file.string() + "': found the ring " + std::to_string(ring));
    }
    point.ring = static_cast<std::uint16_t>(ring);
  }
}

void addCategories(LabelledCloud& cloud, const fs::path& file) {
  const std::string bytes = readText(file);
  if (bytes.size() != cloud.points.size()) {
    throw Error("'" + file.string() + "': found " + std::to_string(bytes.size()) +
                " bytes; it should have one for each of the " +
                std::to_string(cloud.points.size()) + " points");
  }
  cloud.has_labels = true;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    cloud.points[i].number = static_cast<std::uint8_t>(bytes[i]);
  }
}

void addObjects(LabelledCloud& cloud, const json& data, const Pose& X_EG, const Tables& tables) {
  std::map<std::string, int> of_class;
  for (const json& annotation : tables.annotationsOf(data.at("sample_token"))) {
    const json& instance = tables.record("instance", annotation.at("instance_token"));
    const json& category = tables.record("category", instance.at("category_token"));
    LabelledCloud::Object object;
    object.class_name = category.at("name").get<std::string>();
    object.caption = object.class_name + " " + std::to_string(++of_class[object.class_name]);
    object.corners_S = cornersOf(annotation, X_EG);
    cloud.objects[static_cast<std::uint16_t>(cloud.objects.size() + 1)] = object;
  }
  assignToBoxes(cloud);
}

std::vector<LabelledCloud> cloudsOf(const WrittenScene& scene) {
  std::optional<fs::path> points;
  std::optional<fs::path> categories;
  for (const fs::path& file : scene.files) {
    const std::string folder = file.lexically_relative(scene.folder).begin()->string();
    if (file.extension() == ".bin") (folder == "lidarseg" ? categories : points) = file;
  }
  if (!points) return {};
  const Tables tables(scene);
  LabelledCloud cloud;
  if (const auto lidar = scene.settings.find("lidar"); lidar != scene.settings.end()) {
    cloud.lidar = lidar->second.text();
  }
  readingJson(tables.folder() / "sample_data.json", [&] {
    const json data = tables.dataOf(points->lexically_relative(scene.folder).string());
    const json& sensor = tables.record("calibrated_sensor", data.at("calibrated_sensor_token"));
    addPoints(cloud, *points, poseOf(sensor));
    if (categories) {
      cloud.classes = scene.kept->get<CategoryNames>(tables.folder() / "category.json")->names;
      addCategories(cloud, *categories);
    }
    if (!data.at("is_key_frame").get<bool>()) return;
    const json& ego = tables.record("ego_pose", data.at("ego_pose_token"));
    addObjects(cloud, data, poseOf(ego).inverse(), tables);
  });
  return {cloud};
}

}  // namespace

Format format() { return {"synthetic_dataset/NuScenes", true, readScene, nullptr, cloudsOf}; }

}  // namespace synthetic_dataset::formats::nuscenes
