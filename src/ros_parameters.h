#pragma once

#include <XmlRpcValue.h>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset {

/// What the ROS parameter server answers, as a neutral tree.
[[nodiscard]] Value valueFromXmlRpc(XmlRpc::XmlRpcValue& value);

/// The node's private parameters; `robot_list` also from the global name, as the original has it.
/// An object's `model: "param:/robot_description"` becomes the text of that parameter.
/// @throws Error naming both parameters where that one is not set
[[nodiscard]] Value readRosParameters();

}  // namespace synthetic_dataset
