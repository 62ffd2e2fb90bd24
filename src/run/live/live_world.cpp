#include "run/live/live_world.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "run/live/json_values.h"
#include "run/pictures/floor_plan.h"
#include "run/pictures/map_paper.h"
#include "run/pictures/model_portrait.h"

namespace synthetic_dataset::run {
namespace {

cv::Vec3b inkOf(const std::optional<randomize::Cell>& cell) {
  if (cell == randomize::Cell::kFree) return {252, 252, 252};
  if (cell == randomize::Cell::kOccupied) return {70, 60, 60};
  return {190, 188, 186};
}

Eigen::AlignedBox2d extentOf(const randomize::OccupancyMap& map) {
  const double width = map.resolution() * static_cast<double>(map.width());
  const double height = map.resolution() * static_cast<double>(map.height());
  Eigen::AlignedBox2d extent;
  for (const double x : {0.0, width}) {
    for (const double y : {0.0, height}) extent.extend(map.toGlobal({x, y}));
  }
  return extent;
}

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

Value extentValue(const Eigen::AlignedBox2d& extent) {
  return numbersValue({extent.min().x(), extent.min().y(), extent.max().x(), extent.max().y()});
}

LiveMap pictureOf(const randomize::OccupancyMap& map) {
  constexpr double kLongSide = 1100.0;  // [px]
  LiveMap result;
  result.extent = extentOf(map);
  const Eigen::Vector2d size = result.extent.sizes();
  const double pixel = std::max(size.maxCoeff() / kLongSide, map.resolution() / 4.0);  // [m]
  const int columns = std::max(1, static_cast<int>(std::lround(size.x() / pixel)));
  const int rows = std::max(1, static_cast<int>(std::lround(size.y() / pixel)));
  result.picture.create(rows, columns, CV_8UC3);
  for (int row = 0; row < rows; ++row) {
    const double y = result.extent.max().y() - (row + 0.5) * size.y() / rows;
    for (int column = 0; column < columns; ++column) {
      const double x = result.extent.min().x() + (column + 0.5) * size.x() / columns;
      result.picture.at<cv::Vec3b>(row, column) = inkOf(map.cellAt({x, y}));
    }
  }
  return result;
}

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
