#pragma once

#include <XmlRpcValue.h>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset {

/// What the ROS parameter server answers, as a neutral tree.
[[nodiscard]] Value valueFromXmlRpc(XmlRpc::XmlRpcValue& value);

/// The node's private parameters; `robot_list` also from the global name, as the original has it.
[[nodiscard]] Value readRosParameters();

}  // namespace synthetic_dataset
