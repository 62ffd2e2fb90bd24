#pragma once

#include <string>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// Prints settings as YAML that reads back unchanged: large groups over several lines, small ones
/// on one.
[[nodiscard]] std::string settingsYaml(const Value& settings);

}  // namespace synthetic_dataset::programs
