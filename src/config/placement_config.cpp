#include "config/placement_config.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "config/checked_values.h"
#include "config/distribution_config.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::config {
namespace {

randomize::PlacementMode readMode(Parameters& group) {
  const auto mode = group.optional<std::string>("mode", "map");
  if (mode == "volume") return randomize::PlacementMode::kVolume;
  if (mode == "drop") return randomize::PlacementMode::kDrop;
  if (mode != "map") {
    group.addError("mode", "found '" + mode + "'; it should be map, volume or drop" +
                               didYouMean(mode, {"map", "volume", "drop"}));
  }
  return randomize::PlacementMode::kMap;
}

/// One of two words. @return whether it is the first
bool readWord(Parameters& group, const std::string& name, const std::string& first,
              const std::string& second) {
  const auto word = group.optional<std::string>(name, first);
  if (word != first && word != second) {
    group.addError(name, "found '" + word + "'; it should be " + first + " or " + second);
  }
  return word != second;
}

void refuseOthers(Parameters& group, randomize::PlacementMode mode) {
  if (mode == randomize::PlacementMode::kMap) {
    refuseWithout(group, {"volume", "orientation"}, "mode: volume or drop");
  } else {
    refuseWithout(group,
                  {"map", "map_topic", "received_map", "surface", "height", "highest_surface",
                   "steepest", "unevenness"},
                  "mode: map");
  }
  if (mode != randomize::PlacementMode::kDrop) refuseWithout(group, {"fall_time"}, "mode: drop");
}

double numberFromZero(Parameters& group, const std::string& name, double fallback, double most,
                      const std::string& unit = "") {
  const double number = group.optional(name, fallback);
  if (number >= 0.0 && number <= most) return number;
  group.addError(
      name, "found " + Value(number).text() + "; it should be 0 to " + Value(most).text() + unit);
  return fallback;
}

double heightOf(Parameters& group, const std::string& name, double fallback) {
  const double height = group.optional(name, fallback);
  if (std::abs(height) <= kFarthest) return height;
  group.addError(name, "found " + Value(height).text() + " m; it should be -1e6 to 1e6");
  return fallback;
}

void readSurface(Parameters& group, randomize::PlacementOptions& placement) {
  constexpr double kSteepest = 1.5;  // [rad] nearly a wall
  placement.on_surface = readWord(group, "surface", "below", "none");
  if (!placement.on_surface) {
    placement.height = heightOf(group, "height", placement.height);
    refuseWithout(group, {"highest_surface", "steepest", "unevenness"}, "surface: below");
    return;
  }
  refuseWithout(group, {"height"}, "surface: none");
  randomize::SurfaceOptions& surface = placement.surface;
  surface.highest = heightOf(group, "highest_surface", surface.highest);
  surface.steepest = numberFromZero(group, "steepest", surface.steepest, kSteepest, kAngleUnit);
  surface.unevenness = numberFromZero(group, "unevenness", surface.unevenness, 1e3);
}

void readMap(Parameters& group, randomize::PlacementOptions& placement) {
  placement.map_file = group.maybe<std::string>("map");
  placement.map_topic = group.maybe<std::string>("map_topic");
  placement.received_map = group.maybe<Value>("received_map");
  if (placement.received_map && !placement.map_topic) {
    group.addError("received_map", "found without map_topic, on which it has come");
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
  placement.mode = readMode(group);
  if (placement.mode == randomize::PlacementMode::kMap) {
    readMap(group, placement);
  } else {
    placement.volume = readVolume(group);
    placement.upright = !readWord(group, "orientation", "random", "upright");
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
