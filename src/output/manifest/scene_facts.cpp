#include "output/manifest/scene_facts.h"

namespace synthetic_dataset::output {
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
  facts.distance = object.distance();
  facts.in_view = object.in_view;
  facts.dropped = object.dropped;
  facts.loose_box = object.loose_box;
  facts.silhouette_box = ifKnown(object.silhouette_box);
  facts.visible_box = ifKnown(object.visible_box);
  facts.silhouette_pixels = ifKnown(object.pixels.silhouette);
  facts.visible_pixels = ifKnown(object.pixels.visible);
  facts.visibility = ifKnown(object.visibility);
  facts.truncation = ifKnown(object.truncation);
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
  return facts;
}

}  // namespace synthetic_dataset::output
