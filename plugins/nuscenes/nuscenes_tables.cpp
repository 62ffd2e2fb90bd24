#include "plugins/nuscenes/nuscenes_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "plugins/nuscenes/nuscenes_categories.h"
#include "plugins/nuscenes/nuscenes_samples.h"
#include "plugins/nuscenes/nuscenes_scenes.h"

namespace synthetic_dataset::nuscenes {
namespace {

std::string token(NuScenesTable table, std::int64_t first, std::int64_t second = 0) {
  return nuScenesToken(table, first, second);
}

Json listOf(const Quaternion& q) { return {q(0), q(1), q(2), q(3)}; }

/// nuScenes' bins: 0 to 40, 60, 80 and 100 per cent.
std::string visibilityToken(double visibility) {
  if (visibility < 0.4) return "1";
  if (visibility < 0.6) return "2";
  return visibility < 0.8 ? "3" : "4";
}

/// The members for an object in a sample that `sample_annotation` and `image_annotations` share.
/// @param points  of the lidar, or their substitute
Json annotationOf(const Sample& sample, std::int64_t object, const Annotation& annotation,
                  std::int64_t points) {
  return {{"instance_token", token(NuScenesTable::kInstance, sample.first->sequence, object)},
          {"visibility_token", visibilityToken(annotation.visibility)},
          {"attribute_tokens", Json::array()},
          {"prev", annotation.prev},
          {"next", annotation.next},
          {"num_lidar_pts", points},
          {"num_radar_pts", 0}};
}

/// A sequence of samples, or of an object's annotations.
struct Extent {
  std::int64_t count = 0;
  std::string first;
  std::string last;

  void add(const std::string& token) {
    if (count++ == 0) first = token;
    last = token;
  }
};

class Maker {
 public:
  Maker(const DatasetInfo& dataset, const std::vector<Frame>& frames, NuScenesOptions options)
      : dataset_(dataset), samples_(dataset, frames, options), options_(std::move(options)) {}

  /// Whether each point has a category.
  [[nodiscard]] bool hasLidarseg() const { return options_.lidar && options_.lidarseg; }

  void category(const AddRecord& add) const {
    std::size_t number = 0;
    const auto addOne = [&](const std::string& its_token, const std::string& name) {
      Json record = {{"token", its_token}, {"name", name}, {"description", ""}};
      if (hasLidarseg()) record["index"] = number;
      add(record);
      ++number;
    };
    if (hasLidarseg()) addOne(token(NuScenesTable::kCategory, 0, 2), "noise");
    for (const ClassInfo& each : dataset_.classes) {
      addOne(token(NuScenesTable::kCategory, each.id), each.name);
    }
    if (!hasLidarseg()) return;
    const PointCategories categories(dataset_);
    for (std::size_t i = 0; i < dataset_.world_classes.size(); ++i) {
      if (categories.ofWorld(i) != number) continue;  // shares the category of an object class
      addOne(token(NuScenesTable::kCategory, static_cast<std::int64_t>(i), 1),
             dataset_.world_classes[i]);
    }
  }

  void lidarseg(const AddRecord& add) const {
    for (const auto& sample : samples_.all()) {
      for (const SensorData& each : sample->data) {
        if (!isLidar(*each.frame) || !each.is_keyframe) continue;
        const std::string of = dataToken(dataset_, *each.frame);
        add({{"token", of},
             {"sample_data_token", of},
             {"filename", lidarsegFile(options_.version, of)}});
      }
    }
  }

  static void visibility(const AddRecord& add) {
    const std::array<std::array<const char*, 2>, 4> levels = {
        {{"0", "40"}, {"40", "60"}, {"60", "80"}, {"80", "100"}}};
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const auto& [from, to] = levels[i];
      add({{"token", std::to_string(i + 1)},
           {"level", std::string("v") + from + "-" + to},
           {"description",
            std::string("visibility of whole object is between ") + from + " and " + to + "%"}});
    }
  }

  void sensor(const AddRecord& add) const {
    for (std::size_t i = 0; i < dataset_.cameras.size(); ++i) {
      add({{"token", token(NuScenesTable::kSensor, static_cast<std::int64_t>(i))},
           {"channel", nuScenesChannel(dataset_.cameras, i)},
           {"modality", "camera"}});
    }
    if (!options_.lidar) return;
    add({{"token", token(NuScenesTable::kSensor, lidarIndex())},
         {"channel", kNuScenesLidar},
         {"modality", "lidar"}});
  }

  void calibratedSensor(const AddRecord& add) const {
    for (std::size_t i = 0; i < dataset_.cameras.size(); ++i) {
      const Intrinsics& k = dataset_.cameras[i].model.intrinsics();
      const auto index = static_cast<std::int64_t>(i);
      add({{"token", token(NuScenesTable::kCalibratedSensor, index)},
           {"sensor_token", token(NuScenesTable::kSensor, index)},
           {"translation", {0.0, 0.0, 0.0}},
           // The optical frame in a frame with x ahead, y left and z up.
           {"rotation", {0.5, -0.5, 0.5, -0.5}},
           {"camera_intrinsic", {{k.fx, 0.0, k.cx}, {0.0, k.fy, k.cy}, {0.0, 0.0, 1.0}}}});
    }
    if (!options_.lidar) return;
    const double half = std::sqrt(0.5);
    add({{"token", token(NuScenesTable::kCalibratedSensor, lidarIndex())},
         {"sensor_token", token(NuScenesTable::kSensor, lidarIndex())},
         {"translation", {0.0, 0.0, 0.0}},
         // nuScenes' lidar has x to the right and y ahead.
         {"rotation", {half, 0.0, 0.0, -half}},
         {"camera_intrinsic", Json::array()}});
  }

  void egoPose(const AddRecord& add) const {
    for (const auto& sample : samples_.all()) {
      for (const SensorData& each : sample->data) {
        add({{"token", egoToken(*each.frame)},
             {"timestamp", each.frame->microseconds},
             {"rotation", listOf(each.frame->X_GE.rotation)},
             {"translation", numbersOf(each.frame->X_GE.translation)}});
      }
    }
  }

  void log(const AddRecord& add) const {
    for (std::size_t i = 0; i < motionCount(); ++i) {
      add({{"token", token(NuScenesTable::kLog, static_cast<std::int64_t>(i))},
           {"logfile", motionName(i)},
           {"vehicle", "synthetic_dataset"},
           {"date_captured", ""},
           {"location", "synthetic_dataset"}});
    }
  }

  void map(const AddRecord& add) const {
    Json logs = Json::array();
    for (std::size_t i = 0; i < motionCount(); ++i) {
      logs.push_back(token(NuScenesTable::kLog, static_cast<std::int64_t>(i)));
    }
    add({{"token", token(NuScenesTable::kMap, 0)},
         {"category", "semantic_prior"},
         {"filename", kNuScenesMap},
         {"log_tokens", std::move(logs)}});
  }

  void scene(const AddRecord& add) const {
    std::map<std::int64_t, Extent> extents;  // by sequence
    for (const auto& sample : samples_.all()) {
      extents[sample->first->sequence].add(sample->token());
    }
    const auto motions = static_cast<std::int64_t>(motionCount());
    const std::vector<std::string> splits = dataset_.splitFolders();
    for (const auto& [sequence, extent] : extents) {
      const std::string& split = splits.at(static_cast<std::size_t>(sequence / motions));
      const std::string motion = motionName(static_cast<std::size_t>(sequence % motions));
      add({{"token", token(NuScenesTable::kScene, sequence)},
           {"log_token", token(NuScenesTable::kLog, sequence % motions)},
           {"nbr_samples", extent.count},
           {"first_sample_token", extent.first},
           {"last_sample_token", extent.last},
           {"name", sceneName(dataset_, sequence)},
           {"description", motion.empty() ? split : split + ", " + motion}});
    }
  }

  void sample(const AddRecord& add) const {
    for (const auto& sample : samples_.all()) {
      add({{"token", sample->token()},
           {"timestamp", sample->first->microseconds},
           {"prev", sample->prev},
           {"next", sample->next},
           {"scene_token", token(NuScenesTable::kScene, sample->first->sequence)}});
    }
  }

  void sampleData(const AddRecord& add) const {
    for (const auto& sample : samples_.all()) {
      for (const SensorData& each : sample->data) {
        const Frame& frame = *each.frame;
        const CameraModel* camera =
            isLidar(frame) ? nullptr
                           : &dataset_.cameras.at(static_cast<std::size_t>(frame.camera)).model;
        add({{"token", dataToken(dataset_, frame)},
             {"sample_token", sample->token()},
             {"ego_pose_token", egoToken(frame)},
             {"calibrated_sensor_token", token(NuScenesTable::kCalibratedSensor, frame.camera)},
             {"timestamp", frame.microseconds},
             {"fileformat", camera != nullptr ? options_.image_format : "pcd"},
             {"is_key_frame", each.is_keyframe},
             {"height", camera != nullptr ? camera->height() : 0},
             {"width", camera != nullptr ? camera->width() : 0},
             {"filename", frame.file},
             {"prev", each.prev},
             {"next", each.next}});
      }
    }
  }

  void sampleAnnotation(const AddRecord& add) const {
    for (const auto& sample : samples_.all()) {
      for (const auto& [object, annotation] : sample->annotations) {
        Json record = {{"token", sample->tokenOf(object)},
                       {"sample_token", sample->token()},
                       {"translation", numbersOf(annotation.seen->X_GB.translation)},
                       {"size", numbersOf(annotation.seen->size)},
                       {"rotation", listOf(annotation.seen->X_GB.rotation)}};
        record.update(annotationOf(*sample, object, annotation, pointsOf(annotation)));
        add(record);
      }
    }
  }

  void instance(const AddRecord& add) const {
    std::map<std::pair<std::int64_t, std::int64_t>, Extent> extents;  // by sequence and object
    for (const auto& sample : samples_.all()) {
      for (const auto& [object, annotation] : sample->annotations) {
        extents[{sample->first->sequence, object}].add(sample->tokenOf(object));
      }
    }
    for (const auto& [key, extent] : extents) {
      add({{"token", token(NuScenesTable::kInstance, key.first, key.second)},
           {"category_token", token(NuScenesTable::kCategory, objectAt(key.second).class_id)},
           {"nbr_annotations", extent.count},
           {"first_annotation_token", extent.first},
           {"last_annotation_token", extent.last}});
    }
  }

  /// The table that the devkit's export_2d_annotations_as_json.py makes.
  void imageAnnotations(const AddRecord& add) const {
    for (const auto& sample : samples_.all()) {
      for (const SensorData& each : sample->data) {
        if (isLidar(*each.frame) || !each.is_keyframe) continue;
        for (const SeenObject& seen : each.frame->objects) {
          const auto found = sample->annotations.find(seen.object);
          if (found == sample->annotations.end()) continue;  // too few points
          Json record = {
              {"sample_annotation_token", sample->tokenOf(seen.object)},
              {"sample_data_token", dataToken(dataset_, *each.frame)},
              {"bbox_corners", {seen.box.left, seen.box.top, seen.box.right, seen.box.bottom}},
              {"category_name", objectAt(seen.object).class_name},
              {"filename", each.frame->file}};
          record.update(annotationOf(*sample, seen.object, found->second, pointsOf(found->second)));
          add(record);
        }
      }
    }
  }

 private:
  [[nodiscard]] std::int64_t lidarIndex() const {
    return static_cast<std::int64_t>(dataset_.cameras.size());
  }

  [[nodiscard]] bool isLidar(const Frame& frame) const {
    return nuscenes::isLidar(dataset_, frame);
  }

  [[nodiscard]] std::string egoToken(const Frame& frame) const {
    return token(NuScenesTable::kEgoPose, frame.scene, isLidar(frame) ? 1 : 0);
  }

  /// Without a lidar, pixels replace its points, since training code leaves out objects without
  /// points.
  [[nodiscard]] std::int64_t pointsOf(const Annotation& annotation) const {
    return options_.lidar ? annotation.points : annotation.pixels;
  }

  [[nodiscard]] const ObjectInfo& objectAt(std::int64_t object) const {
    return dataset_.objects.at(static_cast<std::size_t>(object));
  }

  [[nodiscard]] std::size_t motionCount() const {
    return std::max<std::size_t>(dataset_.motions.size(), 1);
  }

  [[nodiscard]] std::string motionName(std::size_t motion) const {
    return dataset_.motions.empty() ? "" : dataset_.motions[motion].name;
  }

  const DatasetInfo& dataset_;
  Samples samples_;
  NuScenesOptions options_;
};

}  // namespace

std::vector<Table> tablesOf(const DatasetInfo& dataset, const std::vector<Frame>& frames,
                            const NuScenesOptions& options) {
  const auto maker = std::make_shared<const Maker>(dataset, frames, options);
  const auto made = [&](void (Maker::*table)(const AddRecord&) const) {
    return [maker, table](const AddRecord& add) { ((*maker).*table)(add); };
  };
  std::vector<Table> tables = {{"category", made(&Maker::category)},
                               {"attribute", [](const AddRecord& /*add*/) {}},
                               {"visibility", &Maker::visibility},
                               {"sensor", made(&Maker::sensor)},
                               {"calibrated_sensor", made(&Maker::calibratedSensor)},
                               {"ego_pose", made(&Maker::egoPose)},
                               {"log", made(&Maker::log)},
                               {"map", made(&Maker::map)},
                               {"scene", made(&Maker::scene)},
                               {"sample", made(&Maker::sample)},
                               {"sample_data", made(&Maker::sampleData)},
                               {"sample_annotation", made(&Maker::sampleAnnotation)},
                               {"instance", made(&Maker::instance)},
                               {"image_annotations", made(&Maker::imageAnnotations)}};
  if (maker->hasLidarseg()) tables.push_back({"lidarseg", made(&Maker::lidarseg)});
  return tables;
}

}  // namespace synthetic_dataset::nuscenes
