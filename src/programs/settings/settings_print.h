#pragma once

#include <string>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// Settings as a YAML file that reads back as they are: groups over several lines, what is small on
/// one.
[[nodiscard]] std::string settingsYaml(const Value& settings);

}  // namespace synthetic_dataset::programs
