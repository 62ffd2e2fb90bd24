#include "plugins/dope/dope_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "plugins/dope/dope_options.h"
#include "plugins/readback/json_file.h"
#include "plugins/readback/json_text.h"
#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/object_model.h"

namespace synthetic_dataset::formats::dope {
namespace {

using nlohmann::json;

json listOf(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }
json listOf(const Eigen::Vector2d& p) { return {p.x(), p.y()}; }

/// Rows of the transposed matrix.
json transposed(const Pose& pose, double scale) {
  json rows = json::array();
  for (int i = 0; i < 3; ++i) {
    rows.push_back({pose.linear()(0, i), pose.linear()(1, i), pose.linear()(2, i), 0.0});
  }
  const Eigen::Vector3d t = scale * pose.translation();
  rows.push_back({t.x(), t.y(), t.z(), 1.0});
  return rows;
}

json quaternionOf(const Pose& pose) {
  Eigen::Quaterniond q(pose.linear());
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  return {q.x(), q.y(), q.z(), q.w()};
}

/// Of a half turn, a quaternion and its negative are as good.
void alignQuaternion(const json& found, json& right) {
  const bool fits =
      found.is_array() && found.size() == 4 &&
      std::all_of(found.begin(), found.end(), [](const json& n) { return n.is_number(); });
  if (!fits) return;
  constexpr double kHalfTurn = 1e-6;  // [rad], about
  double dot = 0.0;
  for (std::size_t i = 0; i < 4; ++i) dot += found[i].get<double>() * right[i].get<double>();
  if (dot >= 0.0 || std::abs(right[3].get<double>()) > kHalfTurn) return;
  for (json& number : right) number = -number.get<double>();
}

class DopeValues : public ValueCheck {
 public:
  DopeValues(DopeOptions options, const DatasetInfo& dataset)
      : options_(options),
        dataset_(dataset),
        is_ndds_(options.style == DopeStyle::kNdds),
        scale_(is_ndds_ ? 100.0 : 1.0) {}

  void checkScene(const TrueScene& truth, FoundFiles& files) override {
    const Scene& scene = truth.scene;
    const std::string name = folderOf(scene.split, scene.camera_index) + sceneNumber(scene.instant);
    files.compareWithScene(name + ".png", truth);
    json objects = json::array();
    for (const SceneObject& object : scene.objects) {
      if (!object.labelled()) continue;
      if (auto entry = entryOf(object, scene.camera)) objects.push_back(std::move(*entry));
    }
    json right = {{"camera_data", cameraDataOf(scene)}, {"objects", std::move(objects)}};
    const auto file = files.take(name + ".json");
    if (!file) return;
    readJson(*file, [&](const json& found) {
      alignQuaternions(found, right);
      compareJson(found, right, name + ".json", files.differences());
    });
  }

  void checkDataset(FoundFiles& files) override {
    const std::vector<std::string> splits =
        dataset_.splits.empty() ? std::vector<std::string>{""} : dataset_.splitFolders();
    for (const std::string& split : splits) {
      for (std::size_t i = 0; i < dataset_.cameras.size(); ++i) {
        const std::string folder = folderOf(split, i);
        files.compareJson(folder + "_object_settings.json", objectSettings());
        if (dataset_.cameras[i].intrinsics_vary) continue;
        files.compareJson(folder + "_camera_settings.json", cameraSettings(dataset_.cameras[i]));
      }
    }
  }

 private:
  [[nodiscard]] std::string folderOf(const std::string& split, std::size_t camera) const {
    return (split.empty() ? "" : split + "/") + dataset_.cameraFolder(camera);
  }

  static void alignQuaternions(const json& found, json& right) {
    const std::string of_camera = "quaternion_xyzw_worldframe";
    alignQuaternion(found.at("camera_data").at(of_camera), right["camera_data"][of_camera]);
    const json& objects = found.at("objects");
    for (std::size_t i = 0; i < std::min(objects.size(), right["objects"].size()); ++i) {
      alignQuaternion(objects[i].at("quaternion_xyzw"), right["objects"][i]["quaternion_xyzw"]);
    }
  }

  [[nodiscard]] json cameraDataOf(const Scene& scene) const {
    const Intrinsics& k = scene.camera.intrinsics();
    const Eigen::Vector3d eye = scene.X_GC.translation();
    const Eigen::Vector3d ahead = scene.X_GC.linear() * Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d up = scene.X_GC.linear() * -Eigen::Vector3d::UnitY();
    return {{"width", scene.camera.width()},
            {"height", scene.camera.height()},
            {"intrinsics", {{"fx", k.fx}, {"fy", k.fy}, {"cx", k.cx}, {"cy", k.cy}}},
            {"camera_look_at",
             {{"at", listOf(Eigen::Vector3d(scale_ * (eye + ahead)))},
              {"eye", listOf(Eigen::Vector3d(scale_ * eye))},
              {"up", listOf(up)}}},
            {"camera_view_matrix", transposed(scene.X_GC.inverse(), scale_)},
            {"location_worldframe", listOf(Eigen::Vector3d(scale_ * eye))},
            {"quaternion_xyzw_worldframe", quaternionOf(scene.X_GC)}};
  }

  /// The corners as nvisii's generator numbers them: from the right front upper one, in x ahead, y
  /// left, z up, around the upper face's front and down, then the same behind.
  static std::array<Eigen::Vector3d, 8> cornersOf(const Cuboid& c) {
    const auto& [low, high] = c;
    return {{{high.x(), low.y(), high.z()},
             {low.x(), low.y(), high.z()},
             {low.x(), high.y(), high.z()},
             {high.x(), high.y(), high.z()},
             {high.x(), low.y(), low.z()},
             {low.x(), low.y(), low.z()},
             {low.x(), high.y(), low.z()},
             {high.x(), high.y(), low.z()}}};
  }

  /// Nothing for an object of which a corner has no place on the image or beside it.
  [[nodiscard]] std::optional<json> entryOf(const SceneObject& object,
                                            const CameraModel& camera) const {
    json entry = {{"class", asJsonHasIt(object.class_name)},
                  {"name", asJsonHasIt(object.name)},
                  {"visibility", object.visibility()},
                  {"location", listOf(Eigen::Vector3d(scale_ * object.X_CO->translation()))},
                  {"quaternion_xyzw", quaternionOf(*object.X_CO)}};
    json local = json::array();
    json cuboid = json::array();
    json projected = json::array();
    for (const Eigen::Vector3d& corner_O : cornersOf(object.cuboid_O)) {
      const Eigen::Vector3d corner_C = *object.X_CO * corner_O;
      const auto pixel = camera.project(corner_C);
      if (!pixel) return std::nullopt;
      local.push_back(listOf(corner_O));
      cuboid.push_back(listOf(Eigen::Vector3d(scale_ * corner_C)));
      projected.push_back(listOf(*pixel));
    }
    const Eigen::Vector3d centre_O = 0.5 * (object.cuboid_O.low + object.cuboid_O.high);
    const Eigen::Vector3d centre_C = *object.X_CO * centre_O;
    const auto centre = camera.project(centre_C);
    if (!centre) return std::nullopt;
    const auto box = boxOf(object, options_.box, camera);
    if (is_ndds_) {
      entry["instance_id"] = object.instance;
      entry["pose_transform"] = transposed(*object.X_CO, scale_);
      entry["cuboid_centroid"] = listOf(Eigen::Vector3d(scale_ * centre_C));
      entry["projected_cuboid_centroid"] = listOf(*centre);
      entry["cuboid"] = std::move(cuboid);
      if (box) {
        entry["bounding_box"] = {{"top_left", {box->top + 0.5, box->left + 0.5}},
                                 {"bottom_right", {box->bottom + 0.5, box->right + 0.5}}};
      }
    } else {
      entry["segmentation_id"] = object.instance;
      entry["px_count_all"] = object.pixels.silhouette();
      entry["px_count_visib"] = object.pixels.visible();
      local.push_back(listOf(centre_O));
      entry["local_cuboid"] = std::move(local);
      projected.push_back(listOf(*centre));
      if (box) {
        entry["bounding_box_minx_maxx_miny_maxy"] = {box->left + 0.5, box->right - 0.5,
                                                     box->top + 0.5, box->bottom - 0.5};
      }
    }
    entry["projected_cuboid"] = std::move(projected);
    return entry;
  }

  [[nodiscard]] json objectSettings() const {
    std::map<std::string, json> by_class;  // the first object of each
    for (std::size_t i = 0; i < dataset_.objects.size(); ++i) {
      const ObjectInfo& object = dataset_.objects[i];
      if (by_class.count(object.class_name) != 0) continue;
      json& settings = by_class[object.class_name];
      settings = {{"class", asJsonHasIt(object.class_name)},
                  {"segmentation_class_id", object.class_id},
                  {"segmentation_instance_id", i + 1},
                  {"fixed_model_transform", transposed(Pose::Identity(), 1.0)}};
      if (!object.model_varies) settings["cuboid_dimensions"] = listOf(sizeOf(dataset_.model(i)));
    }
    json classes = json::array();
    json objects = json::array();
    for (const auto& [name, settings] : by_class) {
      classes.push_back(asJsonHasIt(name));
      objects.push_back(settings);
    }
    return {{"exported_object_classes", classes}, {"exported_objects", objects}};
  }

  [[nodiscard]] Eigen::Vector3d sizeOf(const ObjectModel& model) const {
    if (model.vertices.empty()) return Eigen::Vector3d::Zero();
    Eigen::Vector3d low = model.vertices.front().position;
    Eigen::Vector3d high = low;
    for (const ObjectModel::Vertex& vertex : model.vertices) {
      low = low.cwiseMin(vertex.position);
      high = high.cwiseMax(vertex.position);
    }
    return scale_ * (high - low);
  }

  [[nodiscard]] static json cameraSettings(const CameraDescription& camera) {
    const CameraModel& model = camera.model;
    const Intrinsics& k = model.intrinsics();
    const double field_of_view = 2.0 * std::atan(model.width() / (2.0 * k.fx)) * 180.0 / M_PI;
    json settings = {
        {"name", asJsonHasIt(camera.name)},
        {"horizontal_fov", field_of_view},
        {"intrinsic_settings",
         {{"resX", model.width()},
          {"resY", model.height()},
          {"fx", k.fx},
          {"fy", k.fy},
          {"cx", k.cx},
          {"cy", k.cy},
          {"s", 0.0}}},
        {"captured_image_size", {{"width", model.width()}, {"height", model.height()}}}};
    return {{"camera_settings", json::array({std::move(settings)})}};
  }

  DopeOptions options_;
  DatasetInfo dataset_;
  bool is_ndds_;
  double scale_;  ///< units in a metre
};

}  // namespace

std::unique_ptr<ValueCheck> valueCheck(Parameters& parameters, const DatasetInfo& dataset) {
  return std::make_unique<DopeValues>(readDopeOptions(parameters), dataset);
}

}  // namespace synthetic_dataset::formats::dope
