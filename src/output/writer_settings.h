#pragma once

#include <map>
#include <string>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::output {

/// The settings in a writer's group.
/// @param settings  by their full names, as in a manifest
[[nodiscard]] Value::Map writerSettings(const std::map<std::string, Value>& settings,
                                        const std::string& writer);

}  // namespace synthetic_dataset::output
