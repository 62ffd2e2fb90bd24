#pragma once

#include <XmlRpcValue.h>

#include "config/settings_file.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// Converts an answer of the ROS parameter server to a tree that is independent of ROS.
[[nodiscard]] Value valueFromXmlRpc(XmlRpc::XmlRpcValue& value);

/// The settings of a node: those of the YAML file that the private parameter `settings_file` names,
/// if it is set, overridden by the node's private parameters; `robot_list` may also be a global
/// parameter, as in the original program. An object's `model: "param:/robot_description"` becomes
/// the text of that parameter.
/// @param package_folder  finds ROS packages, for the file's `$(find PKG)`
/// @throws Error when the file cannot be read
[[nodiscard]] Value readRosParameters(const config::TextFinder& package_folder);

}  // namespace synthetic_dataset::programs
