#pragma once

#include <string>
#include <vector>

#include "base/yaml_text/yaml_change.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// The path under which a file contains the setting of a path: settings may be written with slashes
/// in their names (yolo/main_list), as in ROS.
/// @param tree  the file's
[[nodiscard]] base::YamlPath pathAsWritten(const base::YamlPath& path, const Value& tree);

/// A file's tree, with names that contain slashes turned into groups; unchanged if it is not valid
/// as settings.
/// @param origin  for error messages, which are dropped here
[[nodiscard]] Value asGroups(const Value& tree, const std::string& origin);

/// A file's tree in which angles such as "deg(20)" are texts, as they are written.
/// @param tree  one that has numbers for them
/// @param written  the same file, read without converting such texts
[[nodiscard]] Value withAnglesAsWritten(const Value& tree, const Value& written);

/// The names in a group of settings in the order of config/params.yaml.
[[nodiscard]] std::vector<std::string> documentedOrder(const base::YamlPath& group);

/// The path from a request: a list of names and indices.
/// @throws Error for anything else
[[nodiscard]] base::YamlPath pathOf(const Value& list);

}  // namespace synthetic_dataset::programs
