#pragma once

#include <map>
#include <string>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::config {

/// Flattens a tree of settings: maps names such as "camera/far" to JSON. A list is one setting.
[[nodiscard]] std::map<std::string, std::string> flatSettings(const Value& tree);

/// Rebuilds the tree from flat settings.
/// @throws Error for a text that is not a value
[[nodiscard]] Value settingsTree(const std::map<std::string, std::string>& flat);

}  // namespace synthetic_dataset::config
