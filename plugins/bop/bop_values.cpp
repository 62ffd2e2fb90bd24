#include "plugins/bop/bop_values.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "plugins/bop/bop_models.h"
#include "plugins/bop/bop_options.h"
#include "plugins/readback/depth_values.h"
#include "plugins/readback/files.h"
#include "plugins/readback/json_document.h"
#include "plugins/readback/json_text.h"
#include "plugins/readback/model_values.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::formats::bop {
namespace {

using nlohmann::json;

constexpr double kFewestVisible = 0.1;  // of an object that counts: calc_gt_coco.py

json listOf(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

json rowsOf(const Eigen::Matrix3d& m) {
  json rows = json::array();
  for (int i = 0; i < 9; ++i) rows.push_back(m(i / 3, i % 3));
  return rows;
}

std::string digits(std::int64_t number) {
  const std::string text = std::to_string(number);
  return std::string(text.size() < 6 ? 6 - text.size() : 0, '0') + text;
}

/// calc_2d_bbox of the toolkit: from the first pixel, as long as the last is away from it.
json toolkitBox(const std::optional<Box>& box) {
  if (!box) return {-1, -1, -1, -1};
  return {std::llround(box->left + 0.5), std::llround(box->top + 0.5),
          std::llround(box->right - box->left) - 1, std::llround(box->bottom - box->top) - 1};
}

/// Lengths of runs off and on the mask, column by column.
json runsOf(const cv::Mat& mask) {
  json runs = json::array();
  bool is_on = false;
  std::int64_t run = 0;
  for (int column = 0; column < mask.cols; ++column) {
    for (int row = 0; row < mask.rows; ++row) {
      if ((mask.at<uchar>(row, column) != 0) != is_on) {
        runs.push_back(run);
        run = 0;
        is_on = !is_on;
      }
      ++run;
    }
  }
  runs.push_back(run);
  return runs;
}

/// What has been seen of a folder of images.
struct Folder {
  std::size_t images = 0;
  std::int64_t annotations = 0;
};

class BopValues : public ValueCheck {
 public:
  BopValues(BopOptions options, BopModels models, const DatasetInfo& dataset)
      : options_(std::move(options)), models_(std::move(models)), dataset_(dataset) {}

  void checkScene(const TrueScene& truth, FoundFiles& files) override {
    const Scene& scene = truth.scene;
    const std::int64_t image = scene.instant % options_.images_per_scene;
    const std::string split = scene.splitFolder();
    const std::string folder =
        (split == "train" ? options_.train_folder : split) + "/" + digits(sceneId(scene));
    const std::string name = digits(image);
    files.compareWithScene(folder + "/rgb/" + name + options_.formatOf(split), truth);
    const cv::Mat depth = checkDepth(folder + "/depth/" + name + ".png", truth, files);
    Folder& seen = folders_[folder];
    ++seen.images;
    json poses = json::array();
    json infos = json::array();
    json annotations = json::array();
    std::map<int, int> counts;  // of targets, by obj_id
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      const SceneObject& object = scene.objects[i];
      if (!object.X_CO || object.pixels.silhouette_in_image() == 0) continue;
      const std::string end = "/" + name + "_" + digits(static_cast<std::int64_t>(poses.size()));
      files.compareMask(folder + "/mask" + end + ".png", object.silhouette());
      files.compareMask(folder + "/mask_visib" + end + ".png", object.visible_mask());
      poses.push_back(poseOf(object, i));
      infos.push_back(infoOf(object, depth));
      if (!object.visible_mask().empty()) {
        annotations.push_back(annotationOf(object, i, image, ++seen.annotations));
      }
      if (object.visibility() >= kFewestVisible) ++counts[models_.obj_ids.at(i)];
    }
    const std::string key = std::to_string(image);
    compareEntry(folder + "/scene_camera.json", key, cameraOf(scene), files);
    compareEntry(folder + "/scene_gt.json", key, poses, files);
    compareEntry(folder + "/scene_gt_info.json", key, infos, files);
    if (options_.coco) compareCoco(folder, image, scene, annotations, files);
    for (const auto& [id, count] : counts) {
      if (split != "test") continue;
      targets_.push_back(
          {{"scene_id", sceneId(scene)}, {"im_id", image}, {"obj_id", id}, {"inst_count", count}});
    }
  }

  void checkDataset(FoundFiles& files) override {
    for (const auto& [folder, seen] : folders_) checkFolder(folder, seen, files);
    for (const SplitInfo& split : dataset_.splits) {
      if (split.name == "test") files.compareJson("test_targets_bop19.json", targets_);
    }
    checkModels(files);
    files.compareJson("camera.json", cameraOf(dataset_.cameras.front().model));
    for (const CameraDescription& each : dataset_.cameras) {
      if (dataset_.cameras.size() == 1) break;
      files.compareJson("camera_" + safeFileName(each.name) + ".json", cameraOf(each.model));
    }
    files.compareJson("dataset_info.json", datasetInfo());
  }

 private:
  [[nodiscard]] std::int64_t sceneId(const Scene& scene) const {
    const auto cameras = static_cast<std::int64_t>(dataset_.cameras.size());
    return scene.instant / options_.images_per_scene * cameras +
           static_cast<std::int64_t>(scene.camera_index);
  }

  /// Holds a depth image against the one that is known in its unit, or the sums.
  cv::Mat checkDepth(const std::string& name, const TrueScene& truth, FoundFiles& files) const {
    const auto file = files.take(name);
    if (!file) return {};
    const cv::Mat depth = readPicture(*file, cv::IMREAD_UNCHANGED);
    const cv::Size size(truth.scene.camera.width(), truth.scene.camera.height());
    if (depth.type() != CV_16UC1 || depth.size() != size) {
      files.differences().add(name +
                              ": it should have one channel of 16 bits, as large as the "
                              "image");
      return {};
    }
    if (options_.depth_scale == 1.0 || options_.depth_scale == 0.1) {
      files.comparePixels(name, depth, truth,
                          options_.depth_scale == 1.0 ? "depth.0.001" : "depth.0.0001");
      return depth;
    }
    const double unit = options_.depth_scale / kMillimetres;
    constexpr double kGreatest = 65534.0;  // that a pixel holds for certain
    const std::string problem =
        depthProblem(depth, {unit, 0.5 * unit, kGreatest * unit}, truth.depth_cells);
    if (!problem.empty()) files.differences().add(name + ": " + problem);
    return depth;
  }

  [[nodiscard]] json cameraOf(const Scene& scene) const {
    const Intrinsics& k = scene.camera.intrinsics();
    const Pose X_CG = scene.X_GC.inverse();
    return {{"cam_K", {k.fx, 0.0, k.cx, 0.0, k.fy, k.cy, 0.0, 0.0, 1.0}},
            {"cam_R_w2c", rowsOf(X_CG.linear())},
            {"cam_t_w2c", listOf(kMillimetres * X_CG.translation())},
            {"depth_scale", options_.depth_scale}};
  }

  [[nodiscard]] json poseOf(const SceneObject& object, std::size_t index) const {
    const Eigen::Vector3d origin_O = models_.of(index).X_OM.translation();
    return {{"obj_id", models_.obj_ids.at(index)},
            {"cam_R_m2c", rowsOf(object.X_CO->linear())},
            {"cam_t_m2c", listOf(kMillimetres * (*object.X_CO * origin_O))}};
  }

  [[nodiscard]] static json infoOf(const SceneObject& object, const cv::Mat& depth) {
    int valid = 0;
    if (!depth.empty() && !object.silhouette().empty()) {
      cv::Mat both;
      cv::bitwise_and(depth > 0, object.silhouette().whole(), both);
      valid = cv::countNonZero(both);
    }
    const bool is_seen = object.pixels.visible() > 0;
    const std::optional<Box> none;
    return {{"bbox_obj", toolkitBox(is_seen ? object.silhouette_box() : none)},
            {"bbox_visib", toolkitBox(is_seen ? object.visible_box() : none)},
            {"px_count_all", object.pixels.silhouette()},
            {"px_count_valid", valid},
            {"px_count_visib", object.pixels.visible()},
            {"visib_fract", object.visibility()}};
  }

  [[nodiscard]] json annotationOf(const SceneObject& object, std::size_t index, std::int64_t image,
                                  std::int64_t id) const {
    const Mask& mask = object.visible_mask();
    const cv::Rect bounds = object.silhouette().bounds();
    return {{"image_id", image},
            {"category_id", models_.obj_ids.at(index)},
            {"iscrowd", 0},
            {"area", mask.count()},
            {"bbox", {bounds.x, bounds.y, bounds.width, bounds.height}},
            {"segmentation",
             {{"counts", runsOf(mask.whole())},
              {"size", {mask.imageSize().height, mask.imageSize().width}}}},
            {"width", mask.imageSize().width},
            {"height", mask.imageSize().height},
            {"ignore", object.visibility() < kFewestVisible},
            {"id", id}};
  }

  static void compareEntry(const std::string& name, const std::string& key, const json& right,
                           FoundFiles& files) {
    const auto document = files.kept().get<JsonDocument>(files.folder() / name);
    const auto found = document->content.find(key);
    if (found == document->content.end()) {
      files.differences().add(name + ": '" + key + "' is missing");
    } else {
      compareJson(*found, right, name + "/" + key, files.differences());
    }
  }

  void compareCoco(const std::string& folder, std::int64_t image, const Scene& scene,
                   const json& annotations, FoundFiles& files) const {
    const std::string name = folder + "/scene_gt_coco.json";
    const auto document = files.kept().get<JsonDocument>(files.folder() / name);
    const auto entriesOf = [&](const char* list, const char* member) {
      json entries = json::array();
      for (const json& each : document->content.at(list)) {
        if (each.value(member, json()) == image) entries.push_back(each);
      }
      return entries;
    };
    const json right_image = {
        {"id", image},
        {"file_name", "rgb/" + digits(image) + options_.formatOf(scene.splitFolder())},
        {"width", scene.camera.width()},
        {"height", scene.camera.height()}};
    compareJson(entriesOf("images", "id"), json::array({right_image}),
                name + ", images of " + std::to_string(image), files.differences());
    compareJson(entriesOf("annotations", "image_id"), annotations,
                name + ", annotations of " + std::to_string(image), files.differences());
  }

  void checkFolder(const std::string& folder, const Folder& seen, FoundFiles& files) const {
    for (const std::string name : {"scene_camera", "scene_gt", "scene_gt_info"}) {
      const std::string path = folder + "/" + name + ".json";
      if (!files.take(path)) continue;
      const std::size_t count =
          files.kept().get<JsonDocument>(files.folder() / path)->content.size();
      if (count == seen.images) continue;
      files.differences().add(path, std::to_string(count) + " images", std::to_string(seen.images));
    }
    const std::string path = folder + "/scene_gt_coco.json";
    if (!options_.coco || !files.take(path)) return;
    json found = files.kept().get<JsonDocument>(files.folder() / path)->content;
    found["images"] = found.at("images").size();
    found["annotations"] = found.at("annotations").size();
    json categories = json::array();
    for (const auto& [id, model] : models_.by_id) {
      categories.push_back(
          {{"id", id},
           {"name", std::to_string(id)},
           {"supercategory", asJsonHasIt(dataset_.objects.at(model.object).class_name)}});
    }
    const json right = {{"info", {{"description", "synthetic_dataset"}}},
                        {"licenses", json::array()},
                        {"categories", categories},
                        {"images", seen.images},
                        {"annotations", seen.annotations}};
    compareJson(found, right, path, files.differences());
  }

  void checkModels(FoundFiles& files) const {
    json infos = json::object();
    for (const auto& [id, model] : models_.by_id) {
      ObjectModel surface = dataset_.model(model.object);
      if (surface.vertices.empty()) continue;
      for (ObjectModel::Vertex& each : surface.vertices) {
        each.position -= model.X_OM.translation();
      }
      for (const std::string folder : {"models/", "models_eval/"}) {
        comparePly(folder + "obj_" + digits(id) + ".ply", surface, kMillimetres, files);
      }
      infos[std::to_string(id)] = modelInfoOf(model, surface);
    }
    files.compareJson("models/models_info.json", infos);
    files.compareJson("models_eval/models_info.json", infos);
  }

  static json modelInfoOf(const BopModel& model, const ObjectModel& surface_M) {
    const Cuboid extent = extentOf(surface_M);
    const Eigen::Vector3d low = kMillimetres * extent.low;
    const Eigen::Vector3d size = kMillimetres * (extent.high - extent.low);
    json info = {{"diameter", kMillimetres * surface_M.diameter},
                 {"min_x", low.x()},
                 {"min_y", low.y()},
                 {"min_z", low.z()},
                 {"size_x", size.x()},
                 {"size_y", size.y()},
                 {"size_z", size.z()}};
    for (const Pose& symmetry : model.discrete_symmetries) {
      Eigen::Matrix4d matrix = symmetry.matrix();
      matrix.topRightCorner<3, 1>() *= kMillimetres;
      json numbers = json::array();
      for (int i = 0; i < 16; ++i) numbers.push_back(matrix(i / 4, i % 4));
      info["symmetries_discrete"].push_back(numbers);
    }
    for (const ContinuousSymmetry& symmetry : model.continuous_symmetries) {
      info["symmetries_continuous"].push_back(
          {{"axis", listOf(symmetry.axis)}, {"offset", listOf(kMillimetres * symmetry.offset)}});
    }
    return info;
  }

  [[nodiscard]] json cameraOf(const CameraModel& camera) const {
    const Intrinsics& k = camera.intrinsics();
    return {{"fx", k.fx},
            {"fy", k.fy},
            {"cx", k.cx},
            {"cy", k.cy},
            {"width", camera.width()},
            {"height", camera.height()},
            {"depth_scale", options_.depth_scale}};
  }

  [[nodiscard]] json datasetInfo() const {
    json objects = json::array();
    for (std::size_t i = 0; i < dataset_.objects.size(); ++i) {
      const ObjectInfo& object = dataset_.objects[i];
      objects.push_back(
          {{"name", asJsonHasIt(object.name)},
           {"class", asJsonHasIt(object.class_name)},
           {"id", asJsonHasIt(object.id)},
           {"obj_id", models_.obj_ids.at(i)},
           {"model_origin", listOf(kMillimetres * models_.of(i).X_OM.translation())}});
    }
    json cameras = json::array();
    for (const CameraDescription& each : dataset_.cameras) {
      cameras.push_back({{"name", asJsonHasIt(each.name)},
                         {"frame", asJsonHasIt(each.frame)},
                         {"intrinsics_vary", each.intrinsics_vary}});
    }
    return {{"objects", objects},
            {"cameras", cameras},
            {"images_per_scene", options_.images_per_scene}};
  }

  BopOptions options_;
  BopModels models_;
  DatasetInfo dataset_;
  std::map<std::string, Folder> folders_;
  json targets_ = json::array();
};

}  // namespace

std::unique_ptr<ValueCheck> valueCheck(Parameters& parameters, const DatasetInfo& dataset) {
  BopModels models = readBopModels(parameters, dataset);
  return std::make_unique<BopValues>(readBopOptions(parameters, dataset), std::move(models),
                                     dataset);
}

}  // namespace synthetic_dataset::formats::bop
