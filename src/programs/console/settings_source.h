#pragma once

#include "base/yaml_value.h"
#include "programs/console/command_line.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// The settings of the file that a command line names, and over them its own. Neither a ROS master
/// nor ROS's log folder is needed.
/// @param remark  as base::parseSettings() has it
/// @throws Error naming file and line, or the setting
[[nodiscard]] Value settingsOf(const CommandLine& command_line, const base::Remark& remark);

}  // namespace synthetic_dataset::programs
