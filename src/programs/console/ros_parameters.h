#pragma once

#include <XmlRpcValue.h>

#include "config/settings_file.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// What the ROS parameter server answers, as a neutral tree.
[[nodiscard]] Value valueFromXmlRpc(XmlRpc::XmlRpcValue& value);

/// The settings of a node: those of the YAML file that the private parameter `settings_file` names,
/// if it does, and over them the node's private parameters; `robot_list` also from the global name,
/// as the original has it. An object's `model: "param:/robot_description"` becomes the text of that
/// parameter.
/// @param package_folder  where ROS packages are, for the file's `$(find PKG)`
/// @throws Error when the file cannot be read
[[nodiscard]] Value readRosParameters(const config::TextFinder& package_folder);

}  // namespace synthetic_dataset::programs
