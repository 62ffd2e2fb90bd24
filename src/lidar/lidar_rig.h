#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "lidar/lidar_options.h"
#include "lidar/recorded_sweeps.h"
#include "motion/frame_source.h"
#include "synthetic_dataset/pose.h"
#include "world/world.h"

namespace synthetic_dataset::lidar {

/// A scanner of the run, and where it is at a time.
struct LidarRig {
  std::string name;
  std::string group;  ///< its parameters' full name, for messages
  std::string frame;  ///< its own
  LidarModel model;
  std::optional<Pose> X_GS = std::nullopt;         ///< where it stands; none: it moves
  std::optional<std::size_t> link = std::nullopt;  ///< of the world's links, on which it rides
  motion::FrameId followed = motion::kNoFrame;     ///< its own frame, or that of its carrier
  Pose X_FS = Pose::Identity();                    ///< in the frame or link that it follows

  /// Whether its pose is that of its own frame, which the source of motion has.
  [[nodiscard]] bool followsFrame() const { return !X_GS && !link && !is_carried; }
  bool is_carried = false;  ///< it rides on an object

  std::shared_ptr<const RecordedSweeps> recorded = nullptr;  ///< its clouds; none: rays are cast

  /// When its points are measured around a scene's stamp.
  [[nodiscard]] motion::TimeRange sweepAt(Stamp scene) const;
};

/// What a scanner may be, or be mounted on.
struct LidarSurroundings {
  std::map<std::string, std::string> object_frames;  ///< by the objects' names
  std::vector<world::LidarSensor> sensors;           ///< of the world and of the objects' models
  std::vector<world::LinkInstance> links;            ///< of the world
};

/// @param recorded  its clouds, where it has them
/// @param diagnostics  what the user should know of its sensor
/// @throws Error naming the parameters that would mend it
[[nodiscard]] LidarRig makeLidarRig(const LidarOptions& config, const LidarSurroundings& there,
                                    const motion::FrameSource& frames,
                                    base::Diagnostics& diagnostics,
                                    std::shared_ptr<const RecordedSweeps> recorded = nullptr);

/// Where one is that rides on no link, at a time around `instant`. A frame whose pose is not known
/// then has that of the instant.
[[nodiscard]] Pose lidarPose(const LidarRig& lidar, const motion::FrameSource& frames,
                             Stamp instant, Duration offset = Duration{0});

/// X_GS of all lidars at an instant, by their frames.
/// @param world  as it stands then
[[nodiscard]] std::map<std::string, Pose> posesOf(const std::vector<LidarRig>& lidars,
                                                  const world::World& world,
                                                  const motion::FrameSource& frames, Stamp instant);

}  // namespace synthetic_dataset::lidar
