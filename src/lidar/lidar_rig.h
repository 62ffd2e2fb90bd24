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

/// A scanner of the run, and what determines its pose at a given time.
struct LidarRig {
  std::string name;
  std::string group;  ///< its parameters' full name, for messages
  std::string frame;  ///< its own
  LidarModel model;
  std::optional<Pose> X_GS = std::nullopt;         ///< its fixed pose; none: it moves
  std::optional<std::size_t> link = std::nullopt;  ///< the world's link on which it is mounted
  motion::FrameId followed = motion::kNoFrame;     ///< its own frame, or its carrier's
  Pose X_FS = Pose::Identity();                    ///< in the frame or link that it follows

  /// Whether its pose is that of its own frame, from the source of motion.
  [[nodiscard]] bool followsFrame() const { return !X_GS && !link && !is_carried; }
  bool is_carried = false;  ///< it is mounted on an object

  std::shared_ptr<const RecordedSweeps> recorded = nullptr;  ///< its clouds; null: rays are cast

  /// When its points are measured, relative to a scene's stamp.
  [[nodiscard]] motion::TimeRange sweepAt(Stamp scene) const;
};

/// The sensors that a scanner may be, and the objects and links that it may be mounted on.
struct LidarSurroundings {
  std::map<std::string, std::string> object_frames;  ///< by object name
  std::vector<world::LidarSensor> sensors;           ///< of the world and of the objects' models
  std::vector<world::LinkInstance> links;            ///< of the world
};

/// @param recorded  its recorded clouds, if it has any
/// @param diagnostics  receives what the user should know about its sensor
/// @throws Error naming the parameters that would fix it
[[nodiscard]] LidarRig makeLidarRig(const LidarOptions& config, const LidarSurroundings& there,
                                    const motion::FrameSource& frames,
                                    base::Diagnostics& diagnostics,
                                    std::shared_ptr<const RecordedSweeps> recorded = nullptr);

/// The pose of a lidar that is not mounted on a link, at `offset` from `instant`. If its frame's
/// pose is not known then, that at the instant is used.
[[nodiscard]] Pose lidarPose(const LidarRig& lidar, const motion::FrameSource& frames,
                             Stamp instant, Duration offset = Duration{0});

/// X_GS of all lidars at an instant, by frame.
/// @param world  as it stands at the instant
[[nodiscard]] std::map<std::string, Pose> posesOf(const std::vector<LidarRig>& lidars,
                                                  const world::World& world,
                                                  const motion::FrameSource& frames, Stamp instant);

}  // namespace synthetic_dataset::lidar
