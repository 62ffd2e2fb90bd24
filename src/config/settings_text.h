#pragma once

#include <map>
#include <string>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::config {

/// A tree of settings with a line each: "camera/far" to JSON. Lists count as one setting.
[[nodiscard]] std::map<std::string, std::string> flatSettings(const Value& tree);

/// The tree again.
/// @throws Error for a text that is not a value
[[nodiscard]] Value settingsTree(const std::map<std::string, std::string>& flat);

}  // namespace synthetic_dataset::config
