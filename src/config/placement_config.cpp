#include "config/readers.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "config/checked_values.h"
#include "config/distribution_config.h"

namespace synthetic_dataset::config {
namespace {

void refuseOthers(Parameters& group, randomize::PlacementMode mode) {
  const bool on_map = mode == randomize::PlacementMode::kMap;
  const bool on_ground = mode == randomize::PlacementMode::kGround;
  if (on_map || on_ground) {
    refuseWithout(group, {"volume", "orientation", "rows"}, "mode: volume or drop");
  } else {
    refuseWithout(group, {"highest_surface", "steepest", "unevenness"}, "mode: map or ground");
  }
  if (!on_map) {
    refuseWithout(group, {"map", "map_topic", "received_map", "surface", "height"}, "mode: map");
  }
  if (!on_ground) refuseWithout(group, {"area"}, "mode: ground");
  if (mode != randomize::PlacementMode::kDrop) refuseWithout(group, {"fall_time"}, "mode: drop");
}

void readStandingOn(Parameters& group, randomize::SurfaceOptions& surface) {
  constexpr double kSteepest = 1.5;  // [rad] nearly a wall
  surface.highest =
      group.optionalBetween("highest_surface", surface.highest, -kFarthest, kFarthest);
  const double steepest = group.optional("steepest", surface.steepest);
  group.declare("steepest", "range", Value::List{0.0, kSteepest});
  if (steepest >= 0.0 && steepest <= kSteepest) {
    surface.steepest = steepest;
  } else {
    group.addError("steepest", "found " + Value(steepest).text() + "; it should be 0.0 to " +
                                   Value(kSteepest).text() + kAngleUnit);
  }
  surface.unevenness = group.optionalBetween("unevenness", surface.unevenness, 0.0, 1e3);
}

void readSurface(Parameters& group, randomize::PlacementOptions& placement) {
  placement.on_surface = listedChoice<bool>(group, "surface", {{"below", true}, {"none", false}});
  if (!placement.on_surface) {
    placement.height = group.optionalBetween("height", placement.height, -kFarthest, kFarthest);
    refuseWithout(group, {"highest_surface", "steepest", "unevenness"}, "surface: below");
    return;
  }
  refuseWithout(group, {"height"}, "surface: none");
  readStandingOn(group, placement.surface);
}

void readMap(Parameters& group, randomize::PlacementOptions& placement) {
  placement.map_file = group.maybe<std::string>("map");
  placement.map_topic = group.maybe<std::string>("map_topic");
  placement.received_map = group.maybe<Value>("received_map");
  if (placement.received_map && !placement.map_topic) {
    group.addError("received_map", "found without map_topic, on which it was received");
  }
  if (placement.map_file) placement.map_file = absolutePath(*placement.map_file);
  if (placement.map_file && placement.map_topic) {
    group.addError("map", "found together with map_topic; the map should come from one of them");
  } else if (!group.has("map") && !group.has("map_topic")) {
    group.addError(
        "map",
        "no map; it should name map_server's YAML file, or map_topic a topic of the bag or of the "
        "running system");
  }
  readSurface(group, placement);
}

std::optional<Eigen::Vector3d> readCorner(Parameters& volume, const std::string& name) {
  const auto numbers = volume.required<std::vector<double>>(name);
  const bool is_near = std::all_of(numbers.begin(), numbers.end(),
                                   [](double each) { return std::abs(each) <= kFarthest; });
  if (numbers.size() == 3 && is_near) return Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  if (numbers.size() == 3) {
    volume.addError(name, "found a number beyond 1e6 m; it should be nearer");
  } else if (!numbers.empty() || isEmptyList(volume, name)) {
    volume.addError(name, "found " + std::to_string(numbers.size()) +
                              " numbers; it should be [x, y, z] in metres");
  }
  return std::nullopt;
}

std::optional<Eigen::Vector2d> readAreaCorner(Parameters& area, const std::string& name) {
  const auto numbers = area.required<std::vector<double>>(name);
  const bool is_near = std::all_of(numbers.begin(), numbers.end(),
                                   [](double each) { return std::abs(each) <= kFarthest; });
  if (numbers.size() == 2 && is_near) return Eigen::Vector2d(numbers[0], numbers[1]);
  if (area.has(name)) {
    area.addError(name, "found " + area.required<Value>(name).text() +
                            "; it should be [x, y] in metres, each at most 1e6");
  }
  return std::nullopt;
}

/// `area: {min: [x, y], max: [x, y]}`.
void readGround(Parameters& group, randomize::PlacementOptions& placement) {
  readStandingOn(group, placement.surface);
  if (!group.has("area")) return;
  Parameters area = group.group("area");
  const auto low = readAreaCorner(area, "min");
  const auto high = readAreaCorner(area, "max");
  if (!low || !high) return;
  if ((low->array() <= high->array()).all()) {
    placement.area = randomize::GroundArea{*low, *high};
  } else {
    group.addError("area", "found a min above the max; min should be the lower corner");
  }
}

}  // namespace

randomize::Volume readVolume(Parameters group) {
  if (!group.has("volume")) {
    group.addError("volume",
                   "missing; it should be {min: [x, y, z], max: [x, y, z]}, a box in global_frame");
    return {};
  }
  Parameters corners = group.group("volume");
  const auto low = readCorner(corners, "min");
  const auto high = readCorner(corners, "max");
  if (!low || !high) return {};
  if ((low->array() <= high->array()).all()) return {*low, *high};
  group.addError("volume", "found a min above the max; min should be the lower corner");
  return {};
}

randomize::PlacementOptions readPlacement(Parameters root) {
  randomize::PlacementOptions placement;
  Parameters group = root.group("placement");
  placement.mode =
      listedChoice<randomize::PlacementMode>(group, "mode",
                                             {{"map", randomize::PlacementMode::kMap},
                                              {"ground", randomize::PlacementMode::kGround},
                                              {"volume", randomize::PlacementMode::kVolume},
                                              {"drop", randomize::PlacementMode::kDrop}});
  if (placement.mode == randomize::PlacementMode::kMap) {
    readMap(group, placement);
  } else if (placement.mode == randomize::PlacementMode::kGround) {
    readGround(group, placement);
  } else {
    placement.volume = readVolume(group);
    placement.upright =
        listedChoice<bool>(group, "orientation", {{"random", false}, {"upright", true}});
    placement.rows = group.optionalBetween("rows", placement.rows, 0.0, 1.0);
  }
  if (placement.mode == randomize::PlacementMode::kDrop) {
    placement.fall_time =
        numberAbove(group, "fall_time", placement.fall_time, randomize::kShortestFall);
  }
  refuseOthers(group, placement.mode);
  constexpr int kMostTries = 1000000;
  placement.tries = group.optionalBetween("tries", placement.tries, 1, kMostTries);
  return placement;
}

}  // namespace synthetic_dataset::config
