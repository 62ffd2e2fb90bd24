#pragma once

#include <string>
#include <vector>

namespace synthetic_dataset::programs {

/// A robot's model on ROS's parameter server.
struct ServerDescription {
  std::string parameter;  ///< "/robot_description", or in a namespace
  std::string robot;      ///< its name in the model
};

/// What a running system has; nothing where no master answers at ROS_MASTER_URI within half a
/// second.
[[nodiscard]] std::vector<ServerDescription> descriptionsOnServer();

}  // namespace synthetic_dataset::programs
