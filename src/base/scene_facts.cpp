#include "base/scene_facts.h"

#include <algorithm>

#include "base/cloud_pictures.h"

namespace synthetic_dataset::base {
namespace {

template <class T>
std::optional<T> ifKnown(const Required<T>& value) {
  return value.isKnown() ? std::optional<T>(value()) : std::nullopt;
}

std::optional<Box> ifKnown(const Required<std::optional<Box>>& box) {
  return box.isKnown() ? box() : std::nullopt;
}

}  // namespace

ObjectFacts objectFacts(const SceneObject& object) {
  ObjectFacts facts;
  facts.X_GO = object.X_GO;
  facts.distance = object.X_CO ? std::optional(object.distance()) : std::nullopt;
  facts.dropped = object.dropped;
  facts.loose_box = object.loose_box;
  facts.silhouette_box = ifKnown(object.silhouette_box);
  if (object.visible_mask.isKnown()) facts.visible_box = object.visibleBox();
  facts.silhouette_pixels = ifKnown(object.pixels.silhouette);
  facts.visible_pixels = ifKnown(object.pixels.visible);
  facts.silhouette_in_image = ifKnown(object.pixels.silhouette_in_image);
  if (facts.silhouette_pixels && facts.visible_pixels) facts.visibility = object.visibility();
  if (facts.silhouette_pixels && facts.silhouette_in_image) facts.truncation = object.truncation();
  facts.cuboid_O = object.cuboid_O;
  facts.bounding_shape_O = object.bounding_shape_O;
  const std::size_t count = std::max(object.keypoints_O.size(), object.keypoints.size());
  for (std::size_t i = 0; i < count; ++i) {
    KeypointFacts keypoint;
    if (i < object.keypoints_O.size()) keypoint.p_O = object.keypoints_O[i];
    if (i < object.keypoints.size()) {
      keypoint.pixel = object.keypoints[i].pixel;
      keypoint.state = ifKnown(object.keypoints[i].state);
    }
    facts.keypoints.push_back(keypoint);
  }
  facts.silhouette = ifKnown(object.silhouette);
  facts.visible_mask = ifKnown(object.visible_mask);
  return facts;
}

SceneFacts sceneFacts(const Scene& scene) {
  SceneFacts facts;
  facts.index = scene.index;
  facts.stamp = scene.stamp;
  facts.instant = scene.instant;
  facts.camera = scene.camera_name;
  facts.width = scene.camera.width();
  facts.height = scene.camera.height();
  facts.split = scene.split;
  facts.X_GC = scene.X_GC;
  facts.camera_model = scene.camera;
  if (!scene.image.empty()) facts.pictures["image"] = scene.image;
  const auto add = [](const char* name, const Required<cv::Mat>& picture,
                      std::map<std::string, cv::Mat>& known) {
    if (picture.isKnown()) known[name] = picture();
  };
  add("class_map", scene.class_map, facts.pictures);
  add("depth", scene.depth, facts.pictures);
  add("normals", scene.normals, facts.pictures);
  add("optical_flow", scene.optical_flow, facts.pictures);
  if (scene.clouds.isKnown()) facts.pictures.merge(cloudPictures(scene.clouds()));
  add("world_map", scene.world_map, facts.link_maps);
  add("part_map", scene.part_map, facts.link_maps);
  return facts;
}

}  // namespace synthetic_dataset::base
