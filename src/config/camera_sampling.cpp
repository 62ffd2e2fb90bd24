#include "config/readers.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "config/checked_values.h"
#include "config/distribution_config.h"

namespace synthetic_dataset::config {
namespace {

/// Reads a distribution that has a default.
void read(Parameters& group, const std::string& name, const DistributionRange& range,
          base::Distribution& value) {
  if (auto given = maybeDistribution(group, name, range)) value = std::move(*given);
}

/// `look_at: any | all | NAME | [x, y, z]`.
void readAim(Parameters& group, randomize::CameraSampling& sampling) {
  const auto given = group.maybe<Value>("look_at");
  if (!given) return;
  if (!given->is<Value::List>()) {
    sampling.look_at = group.required<std::string>("look_at");
    return;
  }
  const auto numbers = group.required<std::vector<double>>("look_at");
  const bool is_near = std::all_of(numbers.begin(), numbers.end(),
                                   [](double each) { return std::abs(each) <= kFarthest; });
  if (numbers.size() == 3 && is_near) {
    sampling.look_at_point_G = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  } else if (numbers.size() == 3) {
    group.addError("look_at", "found a number beyond 1e6 m; it should be nearer");
  } else if (!numbers.empty() || isEmptyList(group, "look_at")) {
    group.addError("look_at", "found " + std::to_string(numbers.size()) +
                                  " numbers; it should be any, all, an object's name or a point "
                                  "[x, y, z] of global_frame");
  }
}

/// `position` in a box, or `distance`, `elevation` and `azimuth`.
void readPlace(Parameters& group, randomize::CameraSampling& sampling) {
  sampling.position_G = maybeDistribution(group, "position", kPlaceRange);
  for (const char* name : {"distance", "elevation", "azimuth"}) {
    if (!group.has("position") || !group.has(name)) continue;
    group.addError(name,
                   "found together with position; the camera's place should come from one "
                   "of them");
    group.ignore(name);
  }
  if (group.has("position")) return;
  constexpr double kNearest = 1e-3;  // [m]
  read(group, "distance", {1, kNearest, kFarthest}, sampling.distance);
  read(group, "elevation", kElevationRange, sampling.elevation);
  read(group, "azimuth", kTurnRange, sampling.azimuth);
}

}  // namespace

std::optional<randomize::CameraSampling> readCameraSampling(Parameters camera) {
  if (!camera.has("sample")) return std::nullopt;
  Parameters group = camera.group("sample");
  randomize::CameraSampling sampling;
  readAim(group, sampling);
  sampling.is_relative_to_size = choice<bool>(group, "unit", {{"metres", false}, {"sizes", true}});
  readPlace(group, sampling);
  if (sampling.is_relative_to_size && (sampling.look_at_point_G || sampling.position_G)) {
    group.addError("unit",
                   "found sizes beside a point to look at or a position, which have none; it "
                   "should be metres, or be left out");
  }
  read(group, "aim_offset", kPlaceRange, sampling.aim_offset);
  read(group, "roll", kTurnRange, sampling.roll);
  sampling.clearance = group.maybeBetween("clearance", 0.0, kFarthest).value_or(sampling.clearance);
  constexpr int kMostTries = 1000000;
  if (group.has("tries")) {
    sampling.tries = group.optionalBetween("tries", sampling.tries, 1, kMostTries);
  }
  return sampling;
}

}  // namespace synthetic_dataset::config
