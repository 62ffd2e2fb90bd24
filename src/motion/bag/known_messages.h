#pragma once

#include <memory>
#include <string>

#include "motion/ros2/message_layout.h"

namespace synthetic_dataset::motion {

/// A message type that can be read.
struct KnownMessage {
  std::string md5sum;                           ///< of ROS 1's type of the same name
  std::shared_ptr<const MessageLayout> layout;  ///< in ROS 2
};

/// @param type  as ROS 1 spells it
/// @return null for a type that cannot be read
[[nodiscard]] const KnownMessage* knownMessage(const std::string& type);

}  // namespace synthetic_dataset::motion
