#include "run/setup/dataset_description.h"

#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "scene/field_of_view.h"
#include "world/mesh/object_mesh.h"

namespace synthetic_dataset::run {
namespace {

ObjectInfo describeObject(const scene::ObjectOptions& config) {
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
  for (const auto& [part, links] : config.parts) object.part_names.push_back(part);
  return object;
}

/// @param field_of_view  drawn at random for each scene
CameraDescription describeCamera(const scene::CameraRig& camera,
                                 const std::optional<base::Distribution>& field_of_view) {
  CameraDescription description{camera.name, camera.optical_frame, camera.model, false};
  if (!field_of_view) return description;
  // A constant field of view does not vary.
  description.intrinsics_vary = field_of_view->lowest() < field_of_view->highest();
  if (!description.intrinsics_vary &&
      scene::canHaveFieldOfView(camera.model, field_of_view->highest())) {
    description.model = scene::withFieldOfView(camera.model, field_of_view->highest());
  }
  return description;
}

bool areAlike(const CameraModel& a, const CameraModel& b) {
  return a.width() == b.width() && a.height() == b.height() && a.intrinsics() == b.intrinsics() &&
         a.distortion() == b.distortion();
}

/// Describes a camera across all motions.
CameraDescription describeCamera(std::size_t camera, const std::vector<MotionSetup>& motions) {
  std::vector<CameraDescription> descriptions;
  for (const MotionSetup& motion : motions) {
    if (camera >= motion.cameras.size()) continue;  // it has an error
    descriptions.push_back(
        describeCamera(motion.cameras[camera], motion.config.randomization.sensor.field_of_view));
  }
  CameraDescription description = descriptions.front();
  for (const CameraDescription& other : descriptions) {
    description.intrinsics_vary = description.intrinsics_vary || other.intrinsics_vary ||
                                  !areAlike(description.model, other.model);
  }
  return description;
}

/// Whether an object has several models, sizes or shapes, over all motions in which it takes part.
/// Models that come from worlds are assumed to be the same in every world.
bool modelVaries(std::size_t object, const std::vector<MotionSetup>& motions) {
  std::set<std::tuple<std::string, double, int>> found;
  for (const MotionSetup& motion : motions) {
    const scene::ObjectOptions& config = motion.config.objects[object];
    if (!config.takes_part || object >= motion.variants.size()) continue;
    for (const scene::ObjectVariant& variant : motion.variants[object].all()) {
      const bool has_own_shape = variant.variety == randomize::Variety::kSameClass;
      found.emplace(variant.model.value_or(""), variant.scale, has_own_shape ? variant.number : 0);
    }
  }
  return found.size() > 1;
}

/// The links of each object's first model, in the first motion's world that has it.
std::vector<std::vector<const world::Link*>> linksByObject(const std::vector<MotionSetup>& motions,
                                                           std::size_t object_count) {
  std::vector<std::vector<const world::Link*>> result(object_count);
  for (auto motion = motions.rbegin(); motion != motions.rend(); ++motion) {
    if (!motion->world) continue;
    std::vector<std::vector<const world::Link*>> here(object_count);
    for (const world::LinkInstance& each : motion->world->links()) {
      if (each.object < 0 || each.variant > 0) continue;
      here[static_cast<std::size_t>(each.object)].push_back(each.link);
    }
    for (std::size_t i = 0; i < object_count; ++i) {
      if (!here[i].empty()) result[i] = std::move(here[i]);
    }
  }
  return result;
}

}  // namespace

DatasetInfo describeDataset(const config::Config& config, const std::vector<MotionSetup>& motions,
                            const SplitPlan& splits) {
  DatasetInfo info;
  for (const scene::ObjectOptions& object : config.objects) {
    info.objects.push_back(describeObject(object));
    info.objects.back().model_varies = modelVaries(info.objects.size() - 1, motions);
  }
  for (const config::ClassConfig& each : config.classes) {
    info.classes.push_back({each.id, each.name});
  }
  for (const auto& [name, patterns] : config.world_classes) info.world_classes.push_back(name);
  for (std::size_t camera = 0; camera < motions.front().cameras.size(); ++camera) {
    info.cameras.push_back(describeCamera(camera, motions));
  }
  for (const lidar::LidarOptions& lidar : config.lidars) {
    info.lidars.push_back({lidar.name, lidar.frame});
  }
  for (const MotionSetup& motion : motions) {
    info.motions.push_back({motion.entry.name, motion.first_instant, motion.instantCount(),
                            !motion.timeline.is_recorded ? 0.0 : motion.config.motion.rate});
  }
  const std::int64_t instants =
      info.motions.back().first_instant + info.motions.back().instant_count;
  info.scene_count = instants * static_cast<std::int64_t>(info.cameras.size());
  info.splits = splits.splits(info.cameras.size());
  info.global_frame = config.global_frame;
  info.setModels([links = linksByObject(motions, config.objects.size())](std::size_t object) {
    std::vector<Pose> X_OL;
    for (const world::Link* link : links.at(object)) X_OL.push_back(link->X_ML);
    return world::objectModel(links.at(object), X_OL);
  });
  return info;
}

}  // namespace synthetic_dataset::run
