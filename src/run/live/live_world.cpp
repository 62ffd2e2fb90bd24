#include "run/live/live_world.h"

#include <algorithm>
#include <cstdint>

#include "run/live/json_values.h"
#include "run/pictures/floor_plan.h"
#include "run/pictures/map_paper.h"
#include "run/pictures/model_portrait.h"

namespace synthetic_dataset::run {
namespace {

Value modelValue(const world::Model& model) {
  world::Description alone;
  alone.models.push_back(model);
  const ModelCounts counts = countModels(alone);
  Value::Map map = {{"name", model.name},
                    {"static", model.is_static},
                    {"links", static_cast<std::int64_t>(counts.links)},
                    {"triangles", static_cast<std::int64_t>(counts.triangles)},
                    {"X", poseValue(model.X_WM)}};
  const Eigen::AlignedBox3d bounds = visibleBounds(alone);
  if (!bounds.isEmpty()) {
    map["low"] = pointValue(bounds.min());
    map["high"] = pointValue(bounds.max());
  }
  return map;
}

Value sensorsValue(const world::Description& description) {
  Value::List sensors;
  for (const world::CameraSensor& camera : description.cameras) {
    sensors.emplace_back(Value::Map{{"name", camera.name},
                                    {"width", camera.camera.width()},
                                    {"height", camera.camera.height()}});
  }
  return sensors;
}

}  // namespace

LiveMap mapOf(const world::Description& description, const std::set<std::string>& objects) {
  std::vector<world::LinkInstance> links;
  std::vector<Pose> X_WL;
  for (const world::Model& model : description.models) {
    if (objects.count(model.name) != 0) continue;
    for (const world::Link& link : model.links) {
      links.push_back({&link, model.is_static ? world::Role::kStatic : world::Role::kProp});
      X_WL.push_back(model.X_WM * link.X_ML);
    }
  }
  const double ground = floorHeight(links, X_WL);
  const Eigen::AlignedBox2d extent = floorExtent(links, X_WL, ground);
  if (extent.isEmpty()) return {};
  const double margin = std::max(0.5, 0.03 * extent.sizes().maxCoeff());  // [m]
  const Eigen::Vector2d around(margin, margin);
  MapPaper paper({extent.min() - around, extent.max() + around});
  drawFloorPlan(paper, links, X_WL, ground);
  return {paper.picture(), paper.extent()};
}

Value::Map liveWorldValue(const LiveWorld& world) {
  Value::List models;
  for (const world::Model& model : world.description.models) models.push_back(modelValue(model));
  Value::List lights;
  for (const world::Light& light : world.description.lights) {
    lights.emplace_back(Value::Map{{"name", light.name}});
  }
  Value::Map map = {{"file", world.file},
                    {"models", models},
                    {"lights", lights},
                    {"sensors", sensorsValue(world.description)},
                    {"missing", namesValue(world.missing)},
                    {"notes", namesValue(world.description.notes)}};
  if (!world.bounds.isEmpty()) {
    map["bounds"] = Value::Map{{"low", pointValue(world.bounds.min())},
                               {"high", pointValue(world.bounds.max())}};
  }
  if (!world.map.picture.empty()) map["map_extent"] = extentValue(world.map.extent);
  return map;
}

}  // namespace synthetic_dataset::run
