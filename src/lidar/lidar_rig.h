#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lidar/lidar_options.h"
#include "motion/frame_source.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::lidar {

/// A scanner of the run, and where it is at a time.
struct LidarRig {
  std::string name;
  std::string group;  ///< its parameters' full name, for messages
  std::string frame;  ///< its own
  LidarModel model;
  std::optional<Pose> X_GS = std::nullopt;      ///< where it stands; none: it moves
  motion::FrameId followed = motion::kNoFrame;  ///< its own frame, or that of its carrier
  Pose X_FS = Pose::Identity();                 ///< in the frame that it follows

  /// Whether its pose is that of its own frame, which the source of motion has.
  [[nodiscard]] bool followsFrame() const { return !X_GS && !is_carried; }
  bool is_carried = false;  ///< it rides on an object
};

/// @param object_frames  by the objects' names
/// @throws Error naming the parameters that would mend it
[[nodiscard]] LidarRig makeLidarRig(const LidarOptions& config,
                                    const std::map<std::string, std::string>& object_frames,
                                    const motion::FrameSource& frames);

/// Where it is at a time around `instant`. A frame whose pose is not known then has that of the
/// instant.
[[nodiscard]] Pose lidarPose(const LidarRig& lidar, const motion::FrameSource& frames,
                             Stamp instant, Duration offset = Duration{0});

/// X_GS of all lidars at a time, by their frames.
[[nodiscard]] std::map<std::string, Pose> posesOf(const std::vector<LidarRig>& lidars,
                                                  const motion::FrameSource& frames, Stamp instant);

}  // namespace synthetic_dataset::lidar
