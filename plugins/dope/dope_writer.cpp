#include <algorithm>
#include <cmath>
#include <map>

#include <pluginlib/class_list_macros.hpp>

#include "plugins/dope/dope_options.h"
#include "plugins/shared/json.h"
#include "plugins/shared/pose_formats.h"
#include "synthetic_dataset/box_choice.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {
namespace {

constexpr std::size_t kCorners = 8;

/// The cuboid's corners in the order of DOPE, NDDS and nvdu, in the object's frame with x ahead, y
/// left and z up (add_cuboid in data_generation/nvisii_data_gen/utils.py), as indices into
/// Cuboid::corners().
constexpr std::array<std::size_t, kCorners> kCornerOrder = {0b101, 0b001, 0b011, 0b111,
                                                            0b100, 0b000, 0b010, 0b110};

Json placeOf(const Eigen::Vector2d& pixel) { return Json::array({pixel.x(), pixel.y()}); }

/// x, y, z, w; of the two that represent the same rotation, the one with w >= 0.
Json quaternionOf(const Pose& pose) {
  Eigen::Quaterniond q(pose.linear());
  if (q.w() < 0.0) q.coeffs() *= -1.0;
  return Json::array({q.x(), q.y(), q.z(), q.w()});
}

/// 4 x 4 for row vectors, p_A = p_B * M: the translation is in the last row, as in NDDS.
Json transposedMatrix(const Pose& pose, double scale) {
  Json rows = Json::array();
  for (int column = 0; column < 3; ++column) {
    rows.push_back(
        {pose.linear()(0, column), pose.linear()(1, column), pose.linear()(2, column), 0.0});
  }
  const Eigen::Vector3d t = scale * pose.translation();
  rows.push_back({t.x(), t.y(), t.z(), 1.0});
  return rows;
}

/// A cuboid in the camera's frame and projected onto its image.
struct ProjectedCuboid {
  std::array<Eigen::Vector3d, kCorners> corners_C;  ///< in the formats' order
  Eigen::Vector3d centre_C = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector2d> corners;  ///< [px]
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
};

/// Nothing if a corner does not project onto the camera's image plane.
std::optional<ProjectedCuboid> projected(const SceneObject& object, const CameraModel& camera) {
  ProjectedCuboid cuboid;
  const auto corners_O = object.cuboid_O.corners();
  for (std::size_t i = 0; i < kCorners; ++i) {
    cuboid.corners_C[i] = *object.X_CO * corners_O[kCornerOrder[i]];
    const auto pixel = camera.project(cuboid.corners_C[i]);
    if (!pixel) return std::nullopt;
    cuboid.corners.push_back(*pixel);
  }
  cuboid.centre_C = *object.X_CO * object.cuboid_O.centre();
  const auto centre = camera.project(cuboid.centre_C);
  if (!centre) return std::nullopt;
  cuboid.centre = *centre;
  return cuboid;
}

double unitsInAMetre(DopeStyle style) { return style == DopeStyle::kNdds ? 100.0 : 1.0; }

void addNddsShape(const SceneObject& object, const ProjectedCuboid& cuboid, Json& entry) {
  const double scale = unitsInAMetre(DopeStyle::kNdds);
  entry["instance_id"] = object.instance;
  entry["pose_transform"] = transposedMatrix(*object.X_CO, scale);
  entry["cuboid_centroid"] = numbersOf(scale * cuboid.centre_C);
  entry["projected_cuboid_centroid"] = placeOf(cuboid.centre);
  for (const Eigen::Vector3d& corner_C : cuboid.corners_C) {
    entry["cuboid"].push_back(numbersOf(scale * corner_C));
  }
}

void addDopeShape(const SceneObject& object, const ProjectedCuboid& cuboid, Json& entry) {
  entry["segmentation_id"] = object.instance;
  entry["px_count_all"] = object.pixels.silhouette();
  entry["px_count_visib"] = object.pixels.visible();
  const auto corners_O = object.cuboid_O.corners();
  for (const std::size_t corner : kCornerOrder) {
    entry["local_cuboid"].push_back(numbersOf(corners_O[corner]));
  }
  entry["local_cuboid"].push_back(numbersOf(object.cuboid_O.centre()));
  entry["projected_cuboid"].push_back(placeOf(cuboid.centre));
}

/// Adds the box: NDDS has rows before columns, counted from the image's edge; DOPE's generators
/// have the first and last column and row.
void addBox(const Box& box, DopeStyle style, Json& entry) {
  if (style == DopeStyle::kNdds) {
    entry["bounding_box"] = {{"top_left", {box.top + 0.5, box.left + 0.5}},
                             {"bottom_right", {box.bottom + 0.5, box.right + 0.5}}};
  } else {
    entry["bounding_box_minx_maxx_miny_maxy"] = {box.left + 0.5, box.right - 0.5, box.top + 0.5,
                                                 box.bottom - 0.5};
  }
}

Json cameraData(const Scene& scene, DopeStyle style) {
  const double scale = unitsInAMetre(style);
  const Intrinsics& k = scene.camera.intrinsics();
  const Eigen::Vector3d eye = scene.X_GC.translation();
  const Eigen::Matrix3d R_GC = scene.X_GC.linear();
  return {{"width", scene.camera.width()},
          {"height", scene.camera.height()},
          {"intrinsics", {{"fx", k.fx}, {"fy", k.fy}, {"cx", k.cx}, {"cy", k.cy}}},
          {"camera_look_at",
           {{"at", numbersOf(scale * (eye + R_GC.col(2)))},
            {"eye", numbersOf(scale * eye)},
            {"up", numbersOf(-R_GC.col(1))}}},
          {"camera_view_matrix", transposedMatrix(scene.X_GC.inverse(), scale)},
          {"location_worldframe", numbersOf(scale * eye)},
          {"quaternion_xyzw_worldframe", quaternionOf(scene.X_GC)}};
}

/// The content of `_camera_settings.json`.
Json cameraSettings(const CameraDescription& camera) {
  const CameraModel& model = camera.model;
  const Intrinsics& k = model.intrinsics();
  const double field_of_view = 2.0 * std::atan(0.5 * model.width() / k.fx) * 180.0 / M_PI;
  return {{"camera_settings",
           Json::array({{{"name", camera.name},
                         {"horizontal_fov", field_of_view},
                         {"intrinsic_settings",
                          {{"resX", model.width()},
                           {"resY", model.height()},
                           {"fx", k.fx},
                           {"fy", k.fy},
                           {"cx", k.cx},
                           {"cy", k.cy},
                           {"s", 0.0}}},
                         {"captured_image_size",
                          {{"width", model.width()}, {"height", model.height()}}}}})}};
}

}  // namespace

/// DOPE's and NDDS's datasets: beside each image a JSON file with poses and projected cuboids.
/// https://github.com/NVlabs/Deep_Object_Pose: read by CleanVisiiDopeLoader of common/utils.py,
/// made by data_generation/nvisii_data_gen/utils.py.
class DopeWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset) override {
    dataset_ = dataset;
    options_ = readDopeOptions(parameters);
    warnOfSmallImages(parameters);
    for (std::size_t i = 0; i < dataset.objects.size(); ++i) {
      const ObjectModel model = dataset.model(i);
      sizes_.push_back(model.vertices.empty() ? Eigen::Vector3d::Zero() : boundsOf(model).size());
    }
  }

  /// train2/utils_dope.py of DOPE: CleanVisiiDopeLoader cuts a square of 400 pixels out of each
  /// image.
  void warnOfSmallImages(WriterParameters& parameters) const {
    constexpr int kCut = 400;  // [px]
    for (const CameraDescription& camera : dataset_.cameras) {
      const int width = camera.model.width();
      const int height = camera.model.height();
      if (width >= kCut && height >= kCut) continue;
      parameters.addWarning("the images are of " + std::to_string(width) + " x " +
                            std::to_string(height) +
                            " pixels; the loader of DOPE's training cuts 400 x 400 out of each, "
                            "and fails on smaller ones");
    }
  }

  [[nodiscard]] Requirements doRequirements() const override {
    Requirements requirements;
    requirements.visible_masks = true;
    requirements.visibility = true;
    return requirements;
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    warnOfDistortion(scene.camera, output);
    Json objects = Json::array();
    for (const SceneObject& object : scene.objects) {
      if (!object.labelled()) continue;
      if (const auto cuboid = projected(object, scene.camera)) {
        objects.push_back(entryOf(object, *cuboid, scene.camera));
      } else {
        output.addWarning(object.name +
                          ": part of it is behind the camera; in images like this it has no label");
      }
    }
    const std::string name = folderOf(scene.split, scene.camera_index) + sceneNumber(scene.instant);
    output.addImage(name + ".png", scene.image);
    output.addText(name + ".json", indentedJson({{"camera_data", cameraData(scene, options_.style)},
                                                 {"objects", objects}}));
  }

  void doFinalize(const SceneRecords& /*records*/, DatasetOutput& output) const override {
    const std::string objects = indentedJson(objectSettings());
    std::vector<std::string> splits = {""};
    if (!dataset_.splits.empty()) splits.clear();
    for (const SplitInfo& split : dataset_.splits) splits.push_back(split.name);
    for (const std::string& split : splits) {
      for (std::size_t i = 0; i < dataset_.cameras.size(); ++i) {
        const CameraDescription& camera = dataset_.cameras[i];
        const std::string folder = folderOf(split, i);
        output.addText(folder + "_object_settings.json", objects);
        // If each image has its own intrinsics, they are only in its `camera_data`.
        if (camera.intrinsics_vary) continue;
        output.addText(folder + "_camera_settings.json", indentedJson(cameraSettings(camera)));
      }
    }
  }

  [[nodiscard]] std::string folderOf(const std::string& split, std::size_t camera) const {
    return (split.empty() ? "" : split + "/") + dataset_.cameraFolder(camera);
  }

  /// The entry of an object in a scene's list.
  [[nodiscard]] Json entryOf(const SceneObject& object, const ProjectedCuboid& cuboid,
                             const CameraModel& camera) const {
    Json entry = {
        {"class", object.class_name},
        {"name", object.name},
        {"visibility", object.visibility()},
        {"location", numbersOf(unitsInAMetre(options_.style) * object.X_CO->translation())},
        {"quaternion_xyzw", quaternionOf(*object.X_CO)}};
    for (const Eigen::Vector2d& corner : cuboid.corners) {
      entry["projected_cuboid"].push_back(placeOf(corner));
    }
    if (options_.style == DopeStyle::kNdds) {
      addNddsShape(object, cuboid, entry);
    } else {
      addDopeShape(object, cuboid, entry);
    }
    if (const auto box = boxOf(object, options_.box, camera)) addBox(*box, options_.style, entry);
    return entry;
  }

  /// The content of `_object_settings.json`: an entry for each class, the first of its objects.
  [[nodiscard]] Json objectSettings() const {
    std::map<std::string, Json> by_class;
    for (std::size_t i = 0; i < dataset_.objects.size(); ++i) {
      const ObjectInfo& object = dataset_.objects[i];
      Json settings = {{"class", object.class_name},
                       {"segmentation_class_id", object.class_id},
                       {"segmentation_instance_id", i + 1},
                       {"fixed_model_transform", transposedMatrix(Pose::Identity(), 1.0)}};
      // An object with several models has no single size.
      if (!object.model_varies) {
        settings["cuboid_dimensions"] = numbersOf(unitsInAMetre(options_.style) * sizes_[i]);
      }
      by_class.emplace(object.class_name, std::move(settings));
    }
    Json classes = Json::array();
    Json objects = Json::array();
    for (const auto& [name, settings] : by_class) {
      classes.push_back(name);
      objects.push_back(settings);
    }
    return {{"exported_object_classes", classes}, {"exported_objects", objects}};
  }

  DatasetInfo dataset_;
  DopeOptions options_;
  std::vector<Eigen::Vector3d> sizes_;  ///< of each object's model [m]
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::DopeWriter, synthetic_dataset::LabelWriter)
