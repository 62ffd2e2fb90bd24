#include "dataset_description.h"

#include <string>
#include <utility>

#include "world/mesh/object_mesh.h"

namespace synthetic_dataset {
namespace {

ObjectInfo describeObject(const config::ObjectConfig& config) {
  ObjectInfo object;
  object.name = config.name;
  object.class_name = config.class_name;
  object.id = config.id;
  object.class_id = config.class_id;
  object.keypoint_count = config.farthest_points > 0
                              ? static_cast<std::size_t>(config.farthest_points)
                              : config.keypoints_O.size();
  object.keypoint_names = config.keypoint_names;
  if (object.keypoint_names.empty()) {
    for (std::size_t i = 0; i < object.keypoint_count; ++i) {
      object.keypoint_names.push_back(std::to_string(i));
    }
  }
  object.skeleton = config.skeleton;
  return object;
}

/// The links of each object.
std::vector<std::vector<const world::Link*>> linksByObject(
    const std::vector<world::LinkInstance>& links, std::size_t object_count) {
  std::vector<std::vector<const world::Link*>> result(object_count);
  for (const world::LinkInstance& each : links) {
    if (each.object >= 0) result[static_cast<std::size_t>(each.object)].push_back(each.link);
  }
  return result;
}

}  // namespace

DatasetInfo describeDataset(const config::Config& config, const std::vector<CameraRig>& cameras,
                            const std::vector<world::LinkInstance>& links,
                            std::int64_t instant_count, const SplitPlan& splits) {
  DatasetInfo info;
  for (const config::ObjectConfig& object : config.objects) {
    info.objects.push_back(describeObject(object));
  }
  for (const config::ClassConfig& each : config.classes) {
    info.classes.push_back({each.id, each.name});
  }
  for (const CameraRig& camera : cameras) {
    info.cameras.push_back({camera.name, camera.frame, camera.model});
  }
  info.scene_count = instant_count * static_cast<std::int64_t>(cameras.size());
  info.splits = splits.splits(cameras.size());
  info.global_frame = config.global_frame;
  info.models = [object_links = linksByObject(links, config.objects.size())](std::size_t object) {
    std::vector<Pose> X_OL;
    for (const world::Link* link : object_links.at(object)) X_OL.push_back(link->X_ML);
    return world::objectModel(object_links.at(object), X_OL);
  };
  return info;
}

}  // namespace synthetic_dataset
