#pragma once

#include <map>
#include <string>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::output {

/// The settings below a writer's name.
/// @param settings  by their full names, as a manifest has them
[[nodiscard]] Value::Map writerSettings(const std::map<std::string, Value>& settings,
                                        const std::string& writer);

}  // namespace synthetic_dataset::output
