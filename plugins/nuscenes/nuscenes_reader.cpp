#include <algorithm>
#include <array>

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

/// The corners of an annotation's box, as Box.corners() of the devkit's utils/data_classes.py, in
/// the order of Cuboid::corners().
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

/// The tables that the labels of an image are in.
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
    return scene_.kept->get<ImageAnnotations>(folder_ / "image_annotations.json")->of(image);
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

}  // namespace

Format format() { return {"synthetic_dataset/NuScenes", true, readScene}; }

}  // namespace synthetic_dataset::formats::nuscenes
