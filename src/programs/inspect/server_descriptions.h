#pragma once

#include <string>
#include <vector>

namespace synthetic_dataset::programs {

/// A robot's model on ROS's parameter server.
struct ServerDescription {
  std::string parameter;  ///< "/robot_description", or in a namespace
  std::string robot;      ///< the robot's name in the model
};

/// The models on a running system's parameter server; none if no master answers at ROS_MASTER_URI
/// within half a second.
[[nodiscard]] std::vector<ServerDescription> descriptionsOnServer();

}  // namespace synthetic_dataset::programs
