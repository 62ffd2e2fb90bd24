#include "lidar/lidar_rig.h"

#include "base/name_list.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"

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

}  // namespace

LidarRig makeLidarRig(const LidarOptions& config,
                      const std::map<std::string, std::string>& object_frames,
                      const motion::FrameSource& frames) {
  LidarRig rig{config.name, config.group, config.frame, config.model};
  if (config.on) {
    rig.is_carried = true;
    rig.followed = frames.find(carrierOf(config, object_frames)).value_or(motion::kNoFrame);
    rig.X_FS = config.X_GS.value_or(Pose::Identity());
    return rig;
  }
  rig.X_GS = config.X_GS;
  if (rig.X_GS) return rig;
  rig.followed = frames.find(rig.frame).value_or(motion::kNoFrame);
  if (rig.followed != motion::kNoFrame) return rig;
  throw Error(config.group + ": nothing says where it is; " + config.group +
              "/pose should, or mounted_on, or " + config.group +
              "/frame_id should name a frame: " + frames.lacks(rig.frame));
}

Pose lidarPose(const LidarRig& lidar, const motion::FrameSource& frames, Stamp instant,
               Duration offset) {
  if (lidar.X_GS) return *lidar.X_GS;
  const auto X_GF = frames.pose(lidar.followed, instant + offset);
  return (X_GF ? *X_GF : frames.knownPose(lidar.followed, instant)) * lidar.X_FS;
}

std::map<std::string, Pose> posesOf(const std::vector<LidarRig>& lidars,
                                    const motion::FrameSource& frames, Stamp instant) {
  std::map<std::string, Pose> by_frame;
  for (const LidarRig& lidar : lidars) {
    by_frame.emplace(lidar.frame, lidarPose(lidar, frames, instant));
  }
  return by_frame;
}

}  // namespace synthetic_dataset::lidar
