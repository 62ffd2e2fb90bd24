#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include <opencv2/core.hpp>
#include <opencv2/core/hal/intrin.hpp>
#include <pluginlib/class_list_macros.hpp>

#include "plugins/bop/bop_models.h"
#include "plugins/bop/bop_options.h"
#include "plugins/bop/bop_scenes.h"
#include "plugins/shared/json.h"
#include "plugins/shared/mask_rle.h"
#include "plugins/shared/pose_formats.h"
#include "synthetic_dataset/box_choice.h"
#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/mask.h"

namespace synthetic_dataset {
namespace {

constexpr int kGreatestDepth = 65535;  // maximum value of a pixel

/// The toolkit's minimum visibility of a target, below which it ignores detections.
constexpr double kFewestVisible = 0.1;

struct DepthImage {
  cv::Mat pixels;           ///< CV_16UC1, times the scale: z [mm]; 0 where there is none
  bool is_cut_off = false;  ///< whether something is farther than a pixel can represent
};

/// Converts four depths [m] to a depth image's values, or to something greater than it can
/// represent.
cv::v_int32x4 rounded(const float* depths, double scale) {
  const cv::v_float32x4 depth = cv::v_load(depths);
  const cv::v_float32x4 before = depth & (depth > cv::v_setzero_f32());  // negative: behind
  const cv::v_float64x2 factor = cv::v_setall_f64(kMillimetres / scale);
  const cv::v_float64x2 too_much = cv::v_setall_f64(kGreatestDepth + 1.0);
  const auto two = [&](const cv::v_float64x2& metres) {
    return cv::v_trunc(cv::v_min(metres * factor, too_much) + cv::v_setall_f64(0.5));
  };
  return cv::v_combine_low(two(cv::v_cvt_f64(before)), two(cv::v_cvt_f64_high(before)));
}

DepthImage depthImage(const cv::Mat& depth, double scale) {
  constexpr int kAtOnce = 8;
  const cv::v_int32x4 most = cv::v_setall_s32(kGreatestDepth);
  cv::v_int32x4 greatest = cv::v_setzero_s32();
  DepthImage image{cv::Mat(depth.size(), CV_16UC1), false};
  std::array<float, kAtOnce> last_depths{};
  std::array<std::uint16_t, kAtOnce> last{};
  for (int row = 0; row < depth.rows; ++row) {
    const auto* from = depth.ptr<float>(row);
    auto* to = image.pixels.ptr<std::uint16_t>(row);
    for (int column = 0; column < depth.cols; column += kAtOnce) {
      const int count = std::min(kAtOnce, depth.cols - column);
      const float* depths = from + column;
      if (count < kAtOnce) {
        std::copy_n(depths, count, last_depths.begin());
        depths = last_depths.data();
      }
      const cv::v_int32x4 first = rounded(depths, scale);
      const cv::v_int32x4 second = rounded(depths + kAtOnce / 2, scale);
      greatest = cv::v_max(greatest, cv::v_max(first, second));
      const cv::v_uint16x8 eight = cv::v_pack_u(first & (first <= most), second & (second <= most));
      if (count == kAtOnce) {
        cv::v_store(to + column, eight);
      } else {
        cv::v_store(last.data(), eight);
        std::copy_n(last.begin(), count, to + column);
      }
    }
  }
  image.is_cut_off = cv::v_reduce_max(greatest) > kGreatestDepth;
  return image;
}

std::int64_t wholeNumber(double number) { return std::llround(number); }

/// As the toolkit's misc.calc_2d_bbox: width and height are one less than the count of pixels.
Json toolkitBox(const std::optional<Box>& box) {
  if (!box) return Json::array({-1, -1, -1, -1});
  return Json::array({wholeNumber(box->left + 0.5), wholeNumber(box->top + 0.5),
                      wholeNumber(box->width()) - 1, wholeNumber(box->height()) - 1});
}

/// As the toolkit's pycoco_utils.bbox_from_binary_mask: width and height are the count.
Json cocoBox(const cv::Rect& pixels) {
  return Json::array({pixels.x, pixels.y, pixels.width, pixels.height});
}

/// COCO's uncompressed run lengths.
Json runLengths(const Mask& mask) {
  return {{"counts", masks::columnRuns(mask)},
          {"size", {mask.imageSize().height, mask.imageSize().width}}};
}

Json millimetres(const Eigen::Vector3d& p) { return numbersOf(kMillimetres * p); }

}  // namespace

/// BOP's scene-wise format, for 6D poses: images, depth, masks, poses and models, in millimetres.
/// https://github.com/thodan/bop_toolkit/blob/master/docs/bop_datasets_format.md; details missing
/// there follow its scripts calc_gt_info.py, calc_gt_coco.py and create_test_targets.py.
class BopWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset) override {
    dataset.refuseVaryingModels("mesh in models/");
    dataset_ = dataset;
    models_ = readBopModels(parameters, dataset);
    options_ = readBopOptions(parameters, dataset);
  }

  [[nodiscard]] Requirements doRequirements() const override {
    Requirements requirements;
    requirements.silhouettes = true;
    requirements.visible_masks = true;
    requirements.visibility = true;
    requirements.depth = true;
    return requirements;
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    warnOfDistortion(scene.camera, output);
    BopImage image = placeOf(scene);
    const std::string name = sixDigits(image.im_id);
    output.addImage(image.folder + "/rgb/" + name + options_.formatOf(scene.splitFolder()),
                    scene.image);
    const DepthImage depth = depthImage(scene.depth(), options_.depth_scale);
    output.addImage(image.folder + "/depth/" + name + ".png", depth.pixels);
    if (depth.is_cut_off) {
      output.addWarning(
          "something is farther than a depth image can hold with this `depth_scale`; it "
          "holds 0 there, which means no depth");
    }
    std::map<int, int> target_counts;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      const SceneObject& object = scene.objects[i];
      if (!object.X_CO || object.pixels.silhouette_in_image() == 0) continue;
      const std::string end = "/" + name + "_" + sixDigits(image.poses.size()) + ".png";
      output.addMask(image.folder + "/mask" + end, object.silhouette());
      output.addMask(image.folder + "/mask_visib" + end, object.visible_mask());
      image.poses.push_back(poseOf(object, i));
      image.infos.push_back(infoOf(object, depth.pixels));
      if (options_.coco) addAnnotation(object, i, scene.camera, image);
      if (object.visibility() >= kFewestVisible) ++target_counts[models_.obj_ids.at(i)];
    }
    for (const auto& [obj_id, count] : target_counts) {
      image.targets.push_back({{"scene_id", sceneId(scene)},
                               {"im_id", image.im_id},
                               {"obj_id", obj_id},
                               {"inst_count", count}});
    }
    output.addRecord(kImages, image.record());
  }

  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    addBopSceneFiles(records, options_.coco ? cocoHeader() : Json(), output);
    for (const SplitInfo& split : dataset_.splits) {
      if (split.name == "test") addBopTargets(records, split.name, output);
    }
    addBopModels(models_, dataset_, output);
    output.addText("camera.json", indentedJson(cameraOf(dataset_.cameras.front().model)));
    for (std::size_t i = 0; dataset_.cameras.size() > 1 && i < dataset_.cameras.size(); ++i) {
      const CameraDescription& camera = dataset_.cameras[i];
      output.addText("camera_" + safeFileName(camera.name) + ".json",
                     indentedJson(cameraOf(camera.model)));
    }
    output.addText("dataset_info.json", indentedJson(datasetInfo()));
  }

  /// A number for each camera in each series of images.
  [[nodiscard]] std::int64_t sceneId(const Scene& scene) const {
    return scene.instant / options_.images_per_scene *
               static_cast<std::int64_t>(dataset_.cameras.size()) +
           static_cast<std::int64_t>(scene.camera_index);
  }

  /// The place of a scene's files, and its camera.
  [[nodiscard]] BopImage placeOf(const Scene& scene) const {
    BopImage image;
    image.split = scene.splitFolder();
    image.folder = (image.split == "train" ? options_.train_folder : image.split) + "/" +
                   sixDigits(sceneId(scene));
    image.series = scene.instant / options_.images_per_scene;
    image.im_id = scene.instant % options_.images_per_scene;
    const Pose X_CG = scene.X_GC.inverse();
    image.camera = {{"cam_K", cameraMatrix(scene.camera.intrinsics())},
                    {"cam_R_w2c", rotationMatrix(X_CG)},
                    {"cam_t_w2c", millimetres(X_CG.translation())},
                    {"depth_scale", options_.depth_scale}};
    image.coco_image = {
        {"id", image.im_id},
        {"file_name", "rgb/" + sixDigits(image.im_id) + options_.formatOf(scene.splitFolder())},
        {"width", scene.camera.width()},
        {"height", scene.camera.height()}};
    image.poses = image.infos = image.annotations = image.targets = Json::array();
    return image;
  }

  [[nodiscard]] Json poseOf(const SceneObject& object, std::size_t index) const {
    const Pose X_CM = *object.X_CO * models_.of(index).X_OM;
    return {{"obj_id", models_.obj_ids.at(index)},
            {"cam_R_m2c", rotationMatrix(X_CM)},
            {"cam_t_m2c", millimetres(X_CM.translation())}};
  }

  /// @param depth  as written: 0 where there is none
  [[nodiscard]] static Json infoOf(const SceneObject& object, const cv::Mat& depth) {
    const Mask& silhouette = object.silhouette();  // empty if subtraction has found nothing
    cv::Mat valid;
    if (!silhouette.empty()) {
      cv::bitwise_and(depth(silhouette.bounds()) > 0, silhouette.pixels(), valid);
    }
    const bool is_seen = object.pixels.visible() > 0;
    return {{"bbox_obj", toolkitBox(is_seen ? object.silhouette_box() : std::nullopt)},
            {"bbox_visib", toolkitBox(is_seen ? object.visibleBox() : std::nullopt)},
            {"px_count_all", object.pixels.silhouette()},
            {"px_count_valid", cv::countNonZero(valid)},
            {"px_count_visib", object.pixels.visible()},
            {"visib_fract", object.visibility()}};
  }

  /// Adds the annotation of an object with a visible pixel: its visible mask, with the box around
  /// the part of its silhouette in the image (calc_gt_coco.py uses the files in `mask`).
  void addAnnotation(const SceneObject& object, std::size_t index, const CameraModel& camera,
                     BopImage& image) const {
    const Mask& visible = object.visible_mask();
    if (visible.empty()) return;
    image.annotations.push_back({{"image_id", image.im_id},
                                 {"category_id", models_.obj_ids.at(index)},
                                 {"iscrowd", 0},
                                 {"area", visible.count()},
                                 {"bbox", cocoBox(object.silhouette().bounds())},
                                 {"segmentation", runLengths(visible)},
                                 {"width", camera.width()},
                                 {"height", camera.height()},
                                 {"ignore", object.visibility() < kFewestVisible}});
  }

  [[nodiscard]] Json cocoHeader() const {
    Json categories = Json::array();
    for (const auto& [obj_id, model] : models_.by_id) {
      categories.push_back({{"id", obj_id},
                            {"name", std::to_string(obj_id)},
                            {"supercategory", dataset_.objects.at(model.object).class_name}});
    }
    return {{"info", {{"description", "synthetic_dataset"}}},
            {"licenses", Json::array()},
            {"categories", std::move(categories)}};
  }

  [[nodiscard]] Json cameraOf(const CameraModel& camera) const {
    const Intrinsics& k = camera.intrinsics();
    return {{"fx", k.fx},
            {"fy", k.fy},
            {"cx", k.cx},
            {"cy", k.cy},
            {"width", camera.width()},
            {"height", camera.height()},
            {"depth_scale", options_.depth_scale}};
  }

  /// Information for which the format has no place: the obj_id of each object, the position of its
  /// model's origin in its frame [mm], the cameras, and whether only scene_camera.json has their
  /// intrinsics.
  [[nodiscard]] Json datasetInfo() const {
    Json objects = Json::array();
    for (std::size_t i = 0; i < dataset_.objects.size(); ++i) {
      const ObjectInfo& object = dataset_.objects[i];
      objects.push_back({{"name", object.name},
                         {"class", object.class_name},
                         {"id", object.id},
                         {"obj_id", models_.obj_ids[i]},
                         {"model_origin", millimetres(models_.of(i).X_OM.translation())}});
    }
    Json cameras = Json::array();
    for (const CameraDescription& camera : dataset_.cameras) {
      cameras.push_back({{"name", camera.name},
                         {"frame", camera.frame},
                         {"intrinsics_vary", camera.intrinsics_vary}});
    }
    return {{"objects", std::move(objects)},
            {"cameras", std::move(cameras)},
            {"images_per_scene", options_.images_per_scene}};
  }

  DatasetInfo dataset_;
  BopModels models_;
  BopOptions options_;
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::BopWriter, synthetic_dataset::LabelWriter)
