#pragma once

#include <functional>
#include <string>
#include <vector>

#include <geometry_msgs/TransformStamped.h>

#include "motion/bag/bag.h"

namespace synthetic_dataset::motion {

/// A message type that gives poses of frames.
struct PoseMessage {
  std::string type;             ///< "nav_msgs/Odometry"
  std::string md5sum;           ///< identifies the type in bags
  bool names_frames = true;     ///< whether its messages name the frames that they move
  bool moves_one_frame = true;  ///< otherwise many; numbered if messages do not name them

  /// @param frame  the name of the frame that it moves, or the prefix of the names of many; empty:
  ///     the message's own
  std::function<std::vector<geometry_msgs::TransformStamped>(const BagMessage& message,
                                                             const std::string& frame)>
      read;
};

/// All types that can be read, besides TF and joint states: each has a row and a function.
[[nodiscard]] const std::vector<PoseMessage>& poseMessages();

}  // namespace synthetic_dataset::motion
