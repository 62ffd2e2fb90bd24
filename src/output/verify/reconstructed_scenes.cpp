#include "output/verify/reconstructed_scenes.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include <opencv2/core.hpp>

#include "base/yaml_value.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::output {
namespace {

std::string classTextOf(const RunDescription& run, const ObjectInfo& object) {
  const auto setting = run.settings.find(object.name + "/class");
  if (setting == run.settings.end()) return object.class_name;
  return base::parseYaml(setting->second.value, "setting '" + object.name + "/class'").text();
}

/// The lidars if they are only set in the entries of `motions`, which all have the same ones.
std::vector<LidarDescription> lidarsOfMotions(const RunDescription& run) {
  std::vector<LidarDescription> lidars;
  const auto motions = run.settings.find("motions");
  if (motions == run.settings.end()) return lidars;
  const Value list = base::parseYaml(motions->second.value, "setting 'motions'");
  if (!list.is<Value::List>() || list.as<Value::List>()->empty()) return lidars;
  Parameters all = Parameters(list.as<Value::List>()->front()).group("lidars");
  for (const std::string& name : all.names()) {
    lidars.push_back(
        {name, all.group(name).optional<std::string>("frame_id", name + "/lidar_link")});
  }
  return lidars;
}

/// The run's lidars, according to its settings.
std::vector<LidarDescription> lidarsOf(const RunDescription& run) {
  const std::string begin = "lidars/";
  const std::string end = "/frame_id";
  std::vector<LidarDescription> lidars;
  for (const auto& [name, setting] : run.settings) {
    const bool is_frame = name.rfind(begin, 0) == 0 && name.size() > begin.size() + end.size() &&
                          name.compare(name.size() - end.size(), end.size(), end) == 0;
    if (!is_frame) continue;
    lidars.push_back({name.substr(begin.size(), name.size() - begin.size() - end.size()),
                      base::parseYaml(setting.value, "setting '" + name + "'").text()});
  }
  if (lidars.empty()) lidars = lidarsOfMotions(run);
  std::sort(lidars.begin(), lidars.end(),
            [](const LidarDescription& a, const LidarDescription& b) { return a.name < b.name; });
  return lidars;
}

/// Copies what the facts say about an object; the rest stays unknown.
void addMeasures(const ObjectFacts& facts, const Pose& X_CG, SceneObject& object) {
  object.X_GO = facts.X_GO;
  object.X_CO.reset();
  if (facts.X_GO) object.X_CO = X_CG * *facts.X_GO;
  object.dropped = facts.dropped;
  object.loose_box = facts.loose_box;
  object.cuboid_O = facts.cuboid_O;
  object.bounding_shape_O = facts.bounding_shape_O;
  for (const KeypointFacts& each : facts.keypoints) {
    object.keypoints_O.push_back(each.p_O);
    Keypoint keypoint;
    keypoint.pixel = each.pixel;
    if (object.X_CO) keypoint.depth = (*object.X_CO * each.p_O).z();
    if (each.state) keypoint.state = *each.state;
    object.keypoints.push_back(std::move(keypoint));
  }
  if (facts.silhouette_pixels) {
    object.pixels.silhouette = *facts.silhouette_pixels;
    object.silhouette_box = facts.silhouette_box;
  }
  if (facts.silhouette_in_image) object.pixels.silhouette_in_image = *facts.silhouette_in_image;
  if (facts.visible_pixels) object.pixels.visible = *facts.visible_pixels;
  if (facts.silhouette) object.silhouette = *facts.silhouette;
  if (facts.visible_mask) object.visible_mask = *facts.visible_mask;
}

/// Reassembles the instance map from the objects' visible masks.
cv::Mat instanceMapOf(const Scene& scene) {
  cv::Mat map(scene.camera.height(), scene.camera.width(), CV_16UC1, cv::Scalar(0));
  for (const SceneObject& object : scene.objects) {
    const Mask& mask = object.visible_mask();
    if (!mask.empty()) map(mask.bounds()).setTo(object.instance, mask.pixels());
  }
  return map;
}

/// The classes of what is visible, as indices from 1.
cv::Mat classMapOf(const Scene& scene, const cv::Mat& instances, const DatasetInfo& dataset) {
  cv::Mat map(instances.size(), CV_16UC1, cv::Scalar(0));
  for (const SceneObject& object : scene.objects) {
    const double number = static_cast<double>(dataset.classIndex(object.class_id)) + 1.0;
    const Mask& mask = object.visible_mask();
    if (!mask.empty()) map(mask.bounds()).setTo(number, mask.pixels());
  }
  return map;
}

/// A map of the links' classes or parts; 0 everywhere if none of them is visible.
cv::Mat linkMapOf(const SceneFacts& facts, const std::string& name) {
  const auto known = facts.link_maps.find(name);
  return known != facts.link_maps.end()
             ? known->second
             : cv::Mat(facts.height, facts.width, CV_16UC1, cv::Scalar(0));
}

}  // namespace

ReconstructedScenes::ReconstructedScenes(const RunDescription& run) {
  std::map<int, std::string> class_names;
  for (const auto& each : run.classes) {
    dataset_.classes.push_back({each.id, each.name});
    class_names[each.id] = each.name;
  }
  auto models = std::make_shared<std::vector<std::optional<ObjectModel>>>();
  for (const auto& each : run.objects) {
    ObjectInfo object;
    object.name = each.name;
    object.class_id = each.class_id;
    object.class_name = class_names[each.class_id];
    object.id = each.id;
    object.keypoint_names = each.keypoint_names;
    object.keypoint_count = each.keypoint_names.size();
    object.skeleton = each.skeleton;
    object.part_names = each.part_names;
    object.model_varies = each.model_varies;
    class_texts_.push_back(classTextOf(run, object));
    dataset_.objects.push_back(std::move(object));
    models->push_back(each.model);
  }
  for (const auto& each : run.cameras) {
    if (each.model) {
      dataset_.cameras.push_back({each.name, each.frame, *each.model, each.intrinsics_vary});
    }
  }
  for (const auto& each : run.motions) {
    dataset_.motions.push_back({each.name, each.first_instant, each.instant_count, each.rate});
  }
  dataset_.lidars = lidarsOf(run);
  dataset_.credits = creditInfos(run.credits);
  dataset_.world_classes = run.world_classes;
  dataset_.splits = run.splits;
  dataset_.scene_count = run.scene_count;
  dataset_.global_frame = run.global_frame;
  dataset_.setModels([models](std::size_t object) {
    if (models->at(object)) return *models->at(object);
    throw Error("the manifest has no model of object " + std::to_string(object));
  });
}

std::string ReconstructedScenes::unknownIn(const SceneFacts& facts) const {
  const auto isNamed = [](const auto& list, const std::string& name) {
    return std::any_of(list.begin(), list.end(),
                       [&](const auto& each) { return each.name == name; });
  };
  if (!isNamed(dataset_.cameras, facts.camera)) return "its camera '" + facts.camera + "'";
  if (!facts.split.empty() && !isNamed(dataset_.splits, facts.split)) {
    return "its split '" + facts.split + "'";
  }
  if (facts.objects.size() != dataset_.objects.size()) {
    return "its " + std::to_string(facts.objects.size()) + " objects; there are " +
           std::to_string(dataset_.objects.size());
  }
  for (std::size_t i = 0; i < facts.objects.size(); ++i) {
    const std::size_t count = facts.objects[i].keypoints.size();
    if (count != dataset_.objects[i].keypoint_count) {
      return "the " + std::to_string(count) + " keypoints of '" + dataset_.objects[i].name +
             "'; it has " + std::to_string(dataset_.objects[i].keypoint_count);
    }
  }
  return "";
}

Scene ReconstructedScenes::scene(const SceneFacts& facts) const {
  Scene scene(facts.camera_model.value());
  scene.index = facts.index;
  scene.instant = facts.instant;
  const auto camera =
      std::find_if(dataset_.cameras.begin(), dataset_.cameras.end(),
                   [&](const CameraDescription& each) { return each.name == facts.camera; });
  scene.camera_index = static_cast<std::size_t>(camera - dataset_.cameras.begin());
  scene.name = (dataset_.cameras.size() > 1 ? facts.camera + "/" : "") + sceneNumber(facts.instant);
  scene.camera_name = facts.camera;
  scene.split = facts.split;
  scene.stamp = facts.stamp;
  scene.X_GC = facts.X_GC;
  bool has_masks = true;
  for (std::size_t i = 0; i < facts.objects.size(); ++i) {
    const ObjectInfo& info = dataset_.objects[i];
    SceneObject object;
    object.name = info.name;
    object.class_name = info.class_name;
    object.class_text = class_texts_[i];
    object.id = info.id;
    object.class_id = info.class_id;
    object.instance = static_cast<int>(i) + 1;
    addMeasures(facts.objects[i], facts.X_GC.inverse(), object);
    has_masks = has_masks && object.visible_mask.isKnown();
    scene.objects.push_back(std::move(object));
  }
  if (has_masks) {
    const cv::Mat instances = instanceMapOf(scene);
    scene.class_map = classMapOf(scene, instances, dataset_);
    scene.instance_map = instances;
  }
  scene.world_map = linkMapOf(facts, "world_map");
  scene.part_map = linkMapOf(facts, "part_map");
  scene.setTransforms([frames = facts.frames, global = dataset_.global_frame](
                          const std::string& target, const std::string& source) -> Pose {
    const auto inGlobal = [&](const std::string& frame) -> Pose {
      if (frame == global) return Pose::Identity();
      const auto found = frames.find(frame);
      if (found == frames.end()) throw Error("the manifest does not say where '" + frame + "' is");
      return found->second;
    };
    return inGlobal(target).inverse() * inGlobal(source);
  });
  return scene;
}

}  // namespace synthetic_dataset::output
