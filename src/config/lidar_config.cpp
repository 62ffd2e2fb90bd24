#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "base/name_list.h"
#include "base/seconds.h"
#include "config/checked_values.h"
#include "config/distribution_config.h"
#include "config/pose_config.h"
#include "config/readers.h"
#include "lidar/lidar_options.h"

namespace synthetic_dataset::config {
namespace {

using lidar::LidarModel;
using lidar::LidarOptions;

using lidar::kFarthestSeen;
using lidar::kMostColumns;
using lidar::kMostRings;

/// Reads a list with one number per ring.
std::vector<double> readOfRings(Parameters& group, const std::string& name, std::size_t rings,
                                double least, double most, const std::string& unit) {
  const auto numbers = group.maybe<std::vector<double>>(name);
  if (!numbers) return {};
  const bool in_range = std::all_of(numbers->begin(), numbers->end(),
                                    [&](double each) { return each >= least && each <= most; });
  if (numbers->size() == rings && in_range) return *numbers;
  group.addError(name, "found " + group.required<Value>(name).text() + "; it should be a list of " +
                           std::to_string(rings) + " numbers, one a ring, from " +
                           Value(least).text() + " to " + Value(most).text() + " " + unit);
  return {};
}

/// `beams: {elevations: [...]}` or `{count: N, first: ..., last: ...}`.
void readBeams(Parameters group, LidarModel& model) {
  constexpr double kUp = kHalfTurn / 2.0;
  const std::string angles =
      "angles above the scanner's x-y plane, from -1.571 to 1.571" + std::string(kAngleUnit);
  if (group.has("elevations")) {
    const auto given = group.maybe<std::vector<double>>("elevations");
    const bool is_right =
        given && !given->empty() && given->size() <= kMostRings &&
        std::all_of(given->begin(), given->end(), [](double e) { return std::abs(e) <= kUp; });
    if (given && !is_right) {
      group.addError("elevations", "found " + group.required<Value>("elevations").text() +
                                       "; it should be 1 to 512 " + angles);
    }
    if (is_right) model.elevations = *given;
    refuseWithout(group, {"count", "first", "last"}, "no list of elevations");
  } else if (group.has("count") || model.elevations.empty()) {
    const int count = group.maybeBetween<int>("count", 1, kMostRings).value_or(0);
    const auto first = group.maybeBetween("first", -kUp, kUp);
    const auto last = group.maybeBetween("last", -kUp, kUp);
    if (count == 0 || !first || !last) {
      group.addError("elevations", "missing; it should be a list of " + angles +
                                       ", or count, first and last should give them");
    }
    model.elevations = lidar::evenAngles(std::max(count, 1), first.value_or(0), last.value_or(0));
  }
  const std::size_t rings = model.elevations.size();
  if (model.firing_times.size() != rings) model.firing_times.clear();
  if (group.has("azimuth_offsets")) {
    model.azimuth_offsets =
        readOfRings(group, "azimuth_offsets", rings, -kHalfTurn, kHalfTurn, "rad");
  }
  if (group.has("firing_times")) {
    model.firing_times = readOfRings(group, "firing_times", rings, 0.0, 1.0, "s");
  }
}

/// `azimuth: [first, last]`.
void readAzimuth(Parameters& group, LidarModel& model) {
  const auto given = group.maybe<std::vector<double>>("azimuth");
  if (!given) return;
  constexpr double kRounding = 1e-3;  // whole turns are given with few decimals
  const double turn = 2.0 * kHalfTurn;
  const bool is_right = given->size() == 2 && std::abs((*given)[0]) <= turn &&
                        std::abs((*given)[1]) <= turn && (*given)[0] != (*given)[1] &&
                        std::abs((*given)[1] - (*given)[0]) <= turn + kRounding;
  if (!is_right) {
    group.addError("azimuth", "found " + group.required<Value>("azimuth").text() +
                                  "; it should be [first, last], where a sweep begins and where it "
                                  "ends, from x to y, at most a turn apart" +
                                  kAngleUnit);
    return;
  }
  model.first_azimuth = (*given)[0];
  model.last_azimuth = (*given)[1];
}

/// Reads where rays go, and the lidar's model; without what readChanges reads.
LidarModel readModel(Parameters& group) {
  LidarModel model;
  std::vector<std::string> names = lidar::modelNames();
  const auto name = group.maybeChoice("model", names);
  if (name) model = *lidar::modelOf(*name);
  if (!group.has("model")) {
    model.first_azimuth = kHalfTurn;
    model.last_azimuth = -kHalfTurn;
    if (!group.has("beams")) {
      group.addError("model", "missing, and so are beams and sensor; it should be one of " +
                                  base::listed(names) +
                                  ", or beams should give the rays, or sensor name one of the "
                                  "world's");
      model.elevations = {0.0};
    }
  }
  if (group.has("beams")) readBeams(group.group("beams"), model);
  if (model.elevations.empty()) model.elevations = {0.0};  // the error is already noted
  if (const auto columns = group.maybeBetween<int>("columns", 1, kMostColumns)) {
    model.columns = *columns;
    model.column_period.reset();
  }
  readAzimuth(group, model);
  return model;
}

/// @param model  of the lidar, or any model if a sensor of the world has its own
lidar::LidarChanges readChanges(Parameters& group, const LidarModel& model) {
  lidar::LidarChanges changes;
  constexpr double kFastest = 1000.0;  // [Hz]
  changes.rate = group.maybeBetween("rate", 0.01, kFastest);
  changes.min_range = group.maybeBetween("min_range", 0.0, kFarthestSeen);
  const double least = changes.min_range.value_or(model.min_range);
  if (group.has("max_range") || model.max_range <= least) {
    changes.max_range = numberAbove(group, "max_range", least + 100.0, least);
  }
  constexpr double kCoarsest = 10.0;  // [m]
  changes.resolution = group.maybeBetween("resolution", 0.0, kCoarsest);
  changes.noise = group.maybeBetween("noise", 0.0, kCoarsest);
  changes.dropout = group.maybeBetween("dropout", 0.0, 1.0);
  changes.reach_at_tenth = group.maybeBetween("reach_at_tenth", 0.0, kFarthestSeen);
  return changes;
}

/// Reads the lidar's model, or the changes to the model of a sensor of the world.
void readScanner(Parameters& group, LidarOptions& options) {
  options.sensor = group.maybe<std::string>("sensor");
  if (options.sensor) {
    refuseWithout(group, {"model", "beams", "columns", "azimuth"}, "no sensor");
    LidarModel endless;
    endless.max_range = kFarthestSeen + 1.0;
    options.changes = readChanges(group, endless);
    return;
  }
  options.model = readModel(group);
  options.changes = readChanges(group, options.model);
  options.changes.apply(options.model);
  if (lidar::columnsOf(options.model) <= kMostColumns) return;
  group.addError("rate", "found " + Value(options.model.rate).text() +
                             " Hz, at which a sweep has " +
                             std::to_string(lidar::columnsOf(options.model)) +
                             " columns; it should have at most 65535");
  options.model.rate = 10.0;
}

/// `pose: [x, y, z, qx, qy, qz, qw]` or `{position: [x, y, z], rpy: [roll, pitch, yaw]}`.
std::optional<Pose> readLidarPose(Parameters& group) {
  if (!group.has("pose")) return std::nullopt;
  const auto given = group.maybe<Value>("pose");
  if (!given->is<Value::Map>()) {
    return readPose(group, "pose", ", or {position: [x, y, z], rpy: [roll, pitch, yaw]}");
  }
  Parameters pose = group.group("pose");
  const auto vector = [&](const std::string& name, double most, const std::string& should) {
    const auto numbers = pose.required<std::vector<double>>(name);
    const bool is_right =
        numbers.size() == 3 && std::all_of(numbers.begin(), numbers.end(),
                                           [&](double each) { return std::abs(each) <= most; });
    if (is_right) return Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
    if (pose.has(name) && !numbers.empty()) {
      pose.addError(name,
                    "found " + pose.required<Value>(name).text() + "; it should be " + should);
    }
    return Eigen::Vector3d(0, 0, 0);
  };
  const Eigen::Vector3d position = vector("position", kFarthest, "[x, y, z] [m]");
  const Eigen::Vector3d rpy =
      vector("rpy", 2.0 * kHalfTurn,
             std::string("[roll, pitch, yaw], each at most a turn of 6.283") + kAngleUnit);
  return makePose(position,
                  Eigen::Quaterniond(Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
                                     Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
                                     Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX())));
}

/// Reads `cloud_topic` and its settings.
std::optional<lidar::RecordedSweepOptions> readRecorded(Parameters& group) {
  if (!group.has("cloud_topic")) {
    refuseWithout(group,
                  {"cloud_time", "every", "full_intensity", "label_tolerance", "time_offset"},
                  "cloud_topic");
    return std::nullopt;
  }
  for (const char* const name :
       {"azimuth", "beams", "columns", "dropout", "max_range", "min_range", "model", "noise",
        "rate", "reach_at_tenth", "resolution", "sensor"}) {
    if (!group.has(name)) continue;
    group.ignore(name);
    group.addError(name,
                   "found together with cloud_topic; recorded points are as they were measured");
  }
  constexpr std::int64_t kMost = 1000000;
  constexpr double kLongestOffset = 10.0;    // [s]
  constexpr double kLongestDistance = 1.0;   // [s]
  constexpr double kLeastTolerance = 1e-3;   // [m]
  constexpr double kWidestTolerance = 10.0;  // [m]
  lidar::RecordedSweepOptions recorded;
  recorded.topic = group.required<std::string>("cloud_topic");
  if (group.has("every")) {
    recorded.every = group.optionalBetween<std::int64_t>("every", 1, 1, kMost);
  }
  if (const auto offset = group.maybeBetween("time_offset", -kLongestOffset, kLongestOffset)) {
    recorded.time_offset = base::fromSeconds(*offset);
  }
  recorded.tolerance = group.optionalBetween("label_tolerance", recorded.tolerance, kLeastTolerance,
                                             kWidestTolerance);
  recorded.full_intensity = numberAbove(group, "full_intensity", recorded.full_intensity, 0.0);
  recorded.longest_distance = base::fromSeconds(group.optionalBetween(
      "cloud_time", toSeconds(recorded.longest_distance), 0.0, kLongestDistance));
  return recorded;
}

LidarOptions readLidar(Parameters group, const std::string& name) {
  LidarOptions options;
  options.name = name;
  options.group = group.fullName("");
  options.on = group.maybe<std::string>("mounted_on");
  options.X_GS = readLidarPose(group);
  options.recorded = readRecorded(group);
  if (options.recorded) {
    options.frame = group.maybe<std::string>("frame_id").value_or("");
    return options;
  }
  options.frame = group.optional<std::string>("frame_id", name + lidar::kOwnFrame);
  readScanner(group, options);
  return options;
}

/// Only one lidar's clouds determine the times of scenes, and none if recorded pictures do.
void checkEvery(Parameters& all, const std::vector<LidarOptions>& lidars, bool has_pictures) {
  bool is_said = has_pictures;
  for (const LidarOptions& lidar : lidars) {
    if (!lidar.recorded) continue;
    Parameters group = all.group(lidar.name);
    if (is_said && group.has("every")) {
      group.addError(
          "every", has_pictures ? "found beside a camera's image_topic, whose pictures say when "
                                  "scenes are; twin/every leaves some out"
                                : "found for a second lidar with a cloud_topic; the clouds of the "
                                  "first say when scenes are");
    }
    is_said = true;
  }
}

}  // namespace

std::vector<LidarOptions> readLidars(Parameters root,
                                     const std::vector<scene::CameraOptions>& cameras) {
  std::vector<LidarOptions> lidars;
  if (!root.has("lidars")) return lidars;
  Parameters all = root.group("lidars");
  if (!lidar::canCastRays()) {
    root.addError("lidars", lidar::howToCastRays());
    root.ignore("lidars");
    return lidars;
  }
  std::set<std::string> frames;
  for (const scene::CameraOptions& camera : cameras) {
    if (camera.frame) frames.insert(*camera.frame);
  }
  for (const std::string& name : folderNames(all)) {
    lidars.push_back(readLidar(all.group(name), name));
    if (lidars.back().frame.empty()) continue;  // its clouds give the frame
    if (!frames.insert(lidars.back().frame).second) {
      all.group(name).addError("frame_id", "found '" + lidars.back().frame +
                                               "', which is also the frame of a camera or another "
                                               "lidar; each should have its own");
    }
  }
  checkEvery(all, lidars, std::any_of(cameras.begin(), cameras.end(), [](const auto& camera) {
               return camera.image_topic.has_value();
             }));
  if (all.names().empty()) {
    root.addError("lidars", "found no lidar; it should be a group with a group for each lidar");
  }
  return lidars;
}

}  // namespace synthetic_dataset::config
