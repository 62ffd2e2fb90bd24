#pragma once

#include <vector>

#include "config/config.h"

namespace synthetic_dataset::config {

/// Reads `robot_list` and the group of each object in it.
[[nodiscard]] std::vector<ObjectConfig> readObjects(const Parameters& root);

}  // namespace synthetic_dataset::config
