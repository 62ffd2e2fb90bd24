#pragma once

#include <functional>
#include <string>
#include <vector>

#include <geometry_msgs/TransformStamped.h>

#include "motion/bag/bag.h"

namespace synthetic_dataset::motion {

/// A type of messages that say where frames are.
struct PoseMessage {
  std::string type;             ///< "nav_msgs/Odometry"
  std::string md5sum;           ///< by which bags know it
  bool names_frames = true;     ///< whether its messages name the frames that they move
  bool moves_one_frame = true;  ///< else many; where it does not name them, they are numbered

  /// @param frame  the name of the frame that it moves, or what the names of many begin with;
  ///     empty: the message's own
  std::function<std::vector<geometry_msgs::TransformStamped>(const BagMessage& message,
                                                             const std::string& frame)>
      read;
};

/// All that can be read, besides TF and joint states: a row and a function each.
[[nodiscard]] const std::vector<PoseMessage>& poseMessages();

}  // namespace synthetic_dataset::motion
