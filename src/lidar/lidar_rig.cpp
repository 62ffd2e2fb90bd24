#include "lidar/lidar_rig.h"

#include <algorithm>
#include <utility>

#include "base/name_list.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"
#include "synthetic_dataset/value.h"
#include "world/sensor_lookup.h"

namespace synthetic_dataset::lidar {
namespace {

std::string carrierOf(const LidarOptions& config,
                      const std::map<std::string, std::string>& object_frames) {
  const auto found = object_frames.find(*config.on);
  if (found != object_frames.end()) return found->second;
  constexpr std::size_t kMostNamed = 8;
  std::vector<std::string> names;
  for (const auto& [name, frame] : object_frames) names.push_back(name);
  throw Error(config.group + "/mounted_on: found '" + *config.on +
              "'; it should be an object of robot_list (" + base::listed(names, kMostNamed) + ")" +
              didYouMean(*config.on, names));
}

/// The model of a scanner that a world file describes, turning once per sweep.
LidarModel modelOf(const world::LidarSensor& sensor) {
  LidarModel model;
  model.elevations =
      evenAngles(sensor.elevation.count, sensor.elevation.first, sensor.elevation.last);
  model.columns = sensor.azimuth.count;
  model.first_azimuth = sensor.azimuth.first;
  model.last_azimuth = sensor.azimuth.last;
  // For a whole turn, Gazebo's first and last ray coincide.
  if (isWholeTurn(model) && model.columns > 1) --model.columns;
  model.rate = sensor.update_rate > 0.0 ? sensor.update_rate : model.rate;
  model.min_range = sensor.min_range;
  model.max_range = std::min(sensor.max_range, kFarthestSeen);
  model.resolution = sensor.resolution;
  model.noise = sensor.noise;
  return model;
}

/// The model of a world's sensor, with the settings that override it.
LidarModel modelOf(const world::LidarSensor& sensor, const LidarOptions& config) {
  LidarModel model = modelOf(sensor);
  config.changes.apply(model);
  if (model.elevations.size() > kMostRings || model.columns > kMostColumns) {
    throw Error(config.group + "/sensor: '" + sensor.name + "' has " +
                std::to_string(sensor.elevation.count) + " rings of " +
                std::to_string(model.columns) + " rays; there should be at most " +
                std::to_string(kMostRings) + " of " + std::to_string(kMostColumns));
  }
  if (model.min_range < model.max_range) return model;
  throw Error(config.group + "/min_range: found " + Value(model.min_range).text() +
              "; the world's lidar '" + sensor.name + "' reaches " + Value(model.max_range).text() +
              " m, so that nothing would be left");
}

/// Places a sensor as in the world, if neither a setting nor a frame of its own places it.
void mountAsInWorld(const LidarOptions& config, const world::LidarSensor& sensor,
                    const std::vector<world::LinkInstance>& links, LidarRig& rig) {
  rig.link = base::namingPlace(config.group + "/sensor",
                               [&] { return world::movingLinkOf(sensor, "lidar", links); });
  rig.X_FS = sensor.X_LS;
  if (!rig.link) rig.X_GS = sensor.X_WS;
}

}  // namespace

motion::TimeRange LidarRig::sweepAt(Stamp scene) const {
  if (recorded) return recorded->timesAround(scene);
  const Duration half = sweepTime(model) / 2;
  return {-half, half};
}

LidarRig makeLidarRig(const LidarOptions& config, const LidarSurroundings& there,
                      const motion::FrameSource& frames, base::Diagnostics& diagnostics,
                      std::shared_ptr<const RecordedSweeps> recorded) {
  LidarRig rig{config.name, config.group, config.frame, config.model};
  if (recorded && rig.frame.empty()) {
    rig.frame = recorded->frame().empty() ? config.name + kOwnFrame : recorded->frame();
  }
  rig.recorded = std::move(recorded);
  const world::LidarSensor* sensor = nullptr;
  if (config.sensor) {
    sensor = &world::findSensor(*config.sensor, there.sensors, config.group + "/sensor", "lidar",
                                diagnostics);
    rig.model = modelOf(*sensor, config);
  }
  if (config.on) {
    rig.is_carried = true;
    rig.followed = frames.find(carrierOf(config, there.object_frames)).value_or(motion::kNoFrame);
    rig.X_FS = config.X_GS.value_or(Pose::Identity());
    return rig;
  }
  rig.X_GS = config.X_GS;
  if (rig.X_GS) return rig;
  rig.followed = frames.find(rig.frame).value_or(motion::kNoFrame);
  if (rig.followed != motion::kNoFrame) return rig;
  if (sensor != nullptr) {
    mountAsInWorld(config, *sensor, there.links, rig);
    return rig;
  }
  if (rig.recorded) {
    throw Error(config.group + "/cloud_topic: found clouds of the frame '" + rig.frame +
                "', of which nothing says where it is; " + config.group +
                "/pose should, or mounted_on, or " + config.group +
                "/frame_id should name a frame: " + frames.lacks(rig.frame));
  }
  throw Error(config.group + ": nothing says where it is; " + config.group +
              "/pose should, or mounted_on or sensor, or " + config.group +
              "/frame_id should name a frame: " + frames.lacks(rig.frame));
}

Pose lidarPose(const LidarRig& lidar, const motion::FrameSource& frames, Stamp instant,
               Duration offset) {
  if (lidar.X_GS) return *lidar.X_GS;
  const auto X_GF = frames.pose(lidar.followed, instant + offset);
  return (X_GF ? *X_GF : frames.knownPose(lidar.followed, instant)) * lidar.X_FS;
}

std::map<std::string, Pose> posesOf(const std::vector<LidarRig>& lidars, const world::World& world,
                                    const motion::FrameSource& frames, Stamp instant) {
  std::map<std::string, Pose> by_frame;
  for (const LidarRig& lidar : lidars) {
    by_frame.emplace(lidar.frame, lidar.link ? world.linkPoses()[*lidar.link] * lidar.X_FS
                                             : lidarPose(lidar, frames, instant));
  }
  return by_frame;
}

}  // namespace synthetic_dataset::lidar
