#include "plugins/nuscenes/nuscenes_values.h"

#include <algorithm>
#include <map>
#include <utility>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "plugins/nuscenes/nuscenes_options.h"
#include "plugins/readback/json_file.h"
#include "plugins/readback/json_text.h"
#include "plugins/readback/sequence_values.h"

namespace synthetic_dataset::formats::nuscenes {
namespace {

using nlohmann::json;

std::string token(NuScenesTable table, std::int64_t first, std::int64_t second = 0) {
  return nuScenesToken(table, first, second);
}

json listOf(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

json rotationOf(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q(rotation);
  return {q.w(), q.x(), q.y(), q.z()};
}

/// The same rotation has two quaternions: the one that is found is taken.
void takeSign(const json& found, json& right) {
  const auto is_list = [](const json& list) {
    return list.is_array() && list.size() == 4 &&
           std::all_of(list.begin(), list.end(), [](const json& n) { return n.is_number(); });
  };
  if (!found.is_object() || !is_list(found.value("rotation", json()))) return;
  double product = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    product += found["rotation"][i].get<double>() * right["rotation"][i].get<double>();
  }
  for (json& number : right["rotation"]) {
    if (product < 0.0) number = -number.get<double>();
  }
}

class NuScenesValues : public ValueCheck {
 public:
  NuScenesValues(NuScenesOptions options, const DatasetInfo& dataset)
      : options_(std::move(options)), dataset_(dataset) {
    for (const char* table : {"ego_pose", "sample", "sample_data", "sample_annotation"}) {
      tables_[table] = json::array();
    }
  }

  void checkScene(const TrueScene& truth, FoundFiles& files) override {
    const Scene& scene = truth.scene;
    const auto camera = static_cast<std::int64_t>(scene.camera_index);
    const auto sequence = static_cast<std::int64_t>(nuScenesSequence(dataset_, scene));
    const std::string image = "samples/" + nuScenesChannel(dataset_.cameras, scene.camera_index) +
                              "/" + scene.flatName() + "." + options_.image_format;
    files.compareWithScene(image, truth);
    const std::string of_sample = token(NuScenesTable::kSample, scene.instant);
    const std::int64_t microseconds = scene.stamp.count() / 1000;
    if (last_instant_ != scene.instant) {
      add("sample", {sequence, 0},
          {{"token", of_sample},
           {"timestamp", microseconds},
           {"scene_token", token(NuScenesTable::kScene, sequence)}});
      last_instant_ = scene.instant;
      extents_[sequence].push_back(of_sample);
    }
    const std::string data = token(NuScenesTable::kSampleData, scene.index);
    add("sample_data", {sequence, camera},
        {{"token", data},
         {"sample_token", of_sample},
         {"ego_pose_token", token(NuScenesTable::kEgoPose, scene.index)},
         {"calibrated_sensor_token", token(NuScenesTable::kCalibratedSensor, camera)},
         {"timestamp", microseconds},
         {"fileformat", options_.image_format},
         {"is_key_frame", true},
         {"height", scene.camera.height()},
         {"width", scene.camera.width()},
         {"filename", asJsonHasIt(image)}});
    addEgoPose(scene, microseconds);
    for (const SceneObject& object : scene.objects) {
      const auto box = boxOf(object, options_.box, scene.camera);
      if (object.labelled() && box) addObject(scene, sequence, object, *box, image);
    }
  }

  void checkDataset(FoundFiles& files) override {
    addAnnotations();
    for (const auto& [name, records] : tables_) compareTable(name, records, files);
    compareTable("image_annotations", imageAnnotations(), files);
    compareTable("category", categories(), files);
    compareTable("attribute", json::array(), files);
    compareTable("visibility", visibilities(), files);
    compareCameras(files);
    compareSequences(files);
    files.comparePicture(kNuScenesMap, cv::Mat(1, 1, CV_8UC1, cv::Scalar(0)));
  }

 private:
  using Key = std::pair<std::int64_t, std::int64_t>;

  /// Adds a record, with those before and after it in its chain.
  void add(const std::string& table, const Key& chain, json record) {
    json& records = tables_[table];
    const auto [last, is_first] = last_.try_emplace({table, chain}, records.size());
    record["prev"] = is_first ? json("") : records[last->second]["token"];
    record["next"] = "";
    if (!is_first) records[last->second]["next"] = record["token"];
    last->second = records.size();
    records.push_back(std::move(record));
  }

  /// The ego frame is where the camera is, its x ahead, its y left, its z up.
  void addEgoPose(const Scene& scene, std::int64_t microseconds) {
    const Eigen::Matrix3d optical = scene.X_GC.linear();
    Eigen::Matrix3d ego;
    ego << optical.col(2), -optical.col(0), -optical.col(1);
    tables_["ego_pose"].push_back({{"token", token(NuScenesTable::kEgoPose, scene.index)},
                                   {"timestamp", microseconds},
                                   {"rotation", rotationOf(ego)},
                                   {"translation", listOf(scene.X_GC.translation())}});
  }

  void addObject(const Scene& scene, std::int64_t sequence, const SceneObject& object,
                 const Box& box, const std::string& image) {
    const std::int64_t index = object.instance - 1;
    const std::string of_annotation = token(NuScenesTable::kSampleAnnotation, scene.instant, index);
    seen_.push_back(
        {{"sample_annotation_token", of_annotation},
         {"sample_data_token", token(NuScenesTable::kSampleData, scene.index)},
         {"bbox_corners", {box.left + 0.5, box.top + 0.5, box.right + 0.5, box.bottom + 0.5}},
         {"category_name", asJsonHasIt(object.class_name)},
         {"filename", asJsonHasIt(image)}});
    const auto [known, is_first] = visibilities_.try_emplace(of_annotation);
    auto& [visibility, pixels] = known->second;
    visibility = std::max(visibility, object.visibility());
    pixels += object.pixels.visible();
    if (!is_first) return;  // another camera has seen it
    annotations_[of_annotation] = {sequence, index};
    const Eigen::Vector3d size = object.cuboid_O.high - object.cuboid_O.low;
    const Eigen::Vector3d middle_O = 0.5 * (object.cuboid_O.high + object.cuboid_O.low);
    pending_[scene.instant][index] = {
        {"token", of_annotation},
        {"sample_token", token(NuScenesTable::kSample, scene.instant)},
        {"instance_token", token(NuScenesTable::kInstance, sequence, index)},
        {"attribute_tokens", json::array()},
        {"translation", listOf(*object.X_GO * middle_O)},
        {"size", {size.y(), size.x(), size.z()}},
        {"rotation", rotationOf(object.X_GO->linear())},
        {"num_radar_pts", 0}};
  }

  /// Once all cameras have been looked at: in the order of objects in each sample.
  void addAnnotations() {
    for (auto& [instant, of_objects] : pending_) {
      for (auto& [object, record] : of_objects) {
        const auto& [visibility, pixels] = visibilities_.at(record["token"]);
        record["visibility_token"] = visibility < 0.4   ? "1"
                                     : visibility < 0.6 ? "2"
                                     : visibility < 0.8 ? "3"
                                                        : "4";
        record["num_lidar_pts"] = pixels;
        const Key key = annotations_.at(record["token"]);
        instances_[key].push_back(record["token"]);
        add("sample_annotation", key, record);
      }
    }
    pending_.clear();
  }

  [[nodiscard]] json imageAnnotations() const {
    std::map<std::string, const json*> by_token;
    for (const json& each : tables_.at("sample_annotation")) {
      by_token[each["token"].get<std::string>()] = &each;
    }
    json records = json::array();
    for (json record : seen_) {
      const json& annotation = *by_token.at(record["sample_annotation_token"].get<std::string>());
      for (const char* same : {"instance_token", "visibility_token", "attribute_tokens", "prev",
                               "next", "num_lidar_pts", "num_radar_pts"}) {
        record[same] = annotation[same];
      }
      records.push_back(std::move(record));
    }
    return records;
  }

  [[nodiscard]] json categories() const {
    json records = json::array();
    for (const ClassInfo& each : dataset_.classes) {
      records.push_back({{"token", token(NuScenesTable::kCategory, each.id)},
                         {"name", asJsonHasIt(each.name)},
                         {"description", ""}});
    }
    return records;
  }

  static json visibilities() {
    json records = json::array();
    int number = 0;
    for (const std::string range : {"0-40", "40-60", "60-80", "80-100"}) {
      std::string words = range;
      words.replace(words.find('-'), 1, " and ");
      records.push_back({{"token", std::to_string(++number)},
                         {"level", "v" + range},
                         {"description", "visibility of whole object is between " + words + "%"}});
    }
    return records;
  }

  void compareCameras(FoundFiles& files) const {
    json sensors = json::array();
    json calibrated = json::array();
    for (std::size_t i = 0; i < dataset_.cameras.size(); ++i) {
      const auto index = static_cast<std::int64_t>(i);
      const Intrinsics& k = dataset_.cameras[i].model.intrinsics();
      sensors.push_back({{"token", token(NuScenesTable::kSensor, index)},
                         {"channel", nuScenesChannel(dataset_.cameras, i)},
                         {"modality", "camera"}});
      Eigen::Matrix3d optical;  // in the ego frame
      optical << 0, 0, 1, -1, 0, 0, 0, -1, 0;
      calibrated.push_back(
          {{"token", token(NuScenesTable::kCalibratedSensor, index)},
           {"sensor_token", token(NuScenesTable::kSensor, index)},
           {"translation", {0.0, 0.0, 0.0}},
           {"rotation", rotationOf(optical)},
           {"camera_intrinsic", {{k.fx, 0.0, k.cx}, {0.0, k.fy, k.cy}, {0.0, 0.0, 1.0}}}});
    }
    compareTable("sensor", sensors, files);
    compareTable("calibrated_sensor", calibrated, files);
  }

  void compareSequences(FoundFiles& files) const {
    std::vector<std::string> motions;
    for (const MotionInfo& each : dataset_.motions) motions.push_back(each.name);
    if (motions.empty()) motions.emplace_back();
    json logs = json::array();
    json tokens = json::array();
    for (std::size_t i = 0; i < motions.size(); ++i) {
      tokens.push_back(token(NuScenesTable::kLog, static_cast<std::int64_t>(i)));
      logs.push_back({{"token", tokens.back()},
                      {"logfile", asJsonHasIt(motions[i])},
                      {"vehicle", "synthetic_dataset"},
                      {"date_captured", ""},
                      {"location", "synthetic_dataset"}});
    }
    compareTable("log", logs, files);
    compareTable("map",
                 json::array({json{{"token", token(NuScenesTable::kMap, 0)},
                                   {"category", "semantic_prior"},
                                   {"filename", kNuScenesMap},
                                   {"log_tokens", tokens}}}),
                 files);
    json scenes = json::array();
    for (const auto& [sequence, samples] : extents_) {
      const auto index = static_cast<std::size_t>(sequence);
      const std::string split = dataset_.splitFolders().at(index / motions.size());
      const std::string& motion = motions[index % motions.size()];
      scenes.push_back(
          {{"token", token(NuScenesTable::kScene, sequence)},
           {"log_token", tokens[index % motions.size()]},
           {"nbr_samples", samples.size()},
           {"first_sample_token", samples.front()},
           {"last_sample_token", samples.back()},
           {"name", "scene-" + withZeros(sequence + 1, 4)},
           {"description", asJsonHasIt(motion.empty() ? split : split + ", " + motion)}});
    }
    compareTable("scene", scenes, files);
    json instances = json::array();
    for (const auto& [key, annotations] : instances_) {
      const ObjectInfo& object = dataset_.objects.at(static_cast<std::size_t>(key.second));
      instances.push_back({{"token", token(NuScenesTable::kInstance, key.first, key.second)},
                           {"category_token", token(NuScenesTable::kCategory, object.class_id)},
                           {"nbr_annotations", annotations.size()},
                           {"first_annotation_token", annotations.front()},
                           {"last_annotation_token", annotations.back()}});
    }
    compareTable("instance", instances, files);
  }

  void compareTable(const std::string& table, json right, FoundFiles& files) const {
    const std::string name = options_.version + "/" + table + ".json";
    const auto file = files.take(name);
    if (!file) return;
    readJson(*file, [&](const json& found) {
      for (std::size_t i = 0; found.is_array() && i < std::min(found.size(), right.size()); ++i) {
        if (right[i].contains("rotation")) takeSign(found[i], right[i]);
      }
      compareJson(found, right, name, files.differences());
    });
  }

  NuScenesOptions options_;
  DatasetInfo dataset_;
  std::map<std::string, json> tables_;
  std::map<std::pair<std::string, Key>, std::size_t> last_;  ///< record of each chain of a table
  std::int64_t last_instant_ = -1;
  std::map<std::int64_t, std::vector<std::string>> extents_;  ///< tokens of a sequence's samples
  std::map<Key, std::vector<std::string>> instances_;         ///< tokens of an object's annotations
  std::vector<json> seen_;                                    ///< in images
  std::map<std::string, std::pair<double, std::int64_t>> visibilities_;  ///< and pixels, by token
  std::map<std::string, Key> annotations_;                               ///< by token
  std::map<std::int64_t, std::map<std::int64_t, json>> pending_;         ///< by instant and object
};

}  // namespace

std::unique_ptr<ValueCheck> valueCheck(Parameters& parameters, const DatasetInfo& dataset) {
  return std::make_unique<NuScenesValues>(readNuScenesOptions(parameters), dataset);
}

}  // namespace synthetic_dataset::formats::nuscenes
