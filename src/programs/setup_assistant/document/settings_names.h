#pragma once

#include <string>
#include <vector>

#include "base/yaml_text/yaml_change.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// The path under which a file has what the path means: settings may be written with slashes in
/// their names (yolo/main_list), as ROS has them.
/// @param tree  of the file
[[nodiscard]] base::YamlPath pathAsWritten(const base::YamlPath& path, const Value& tree);

/// A file's tree without slashes in names; as it is where it is not fit for settings.
/// @param origin  for messages, which nobody gets here
[[nodiscard]] Value asGroups(const Value& tree, const std::string& origin);

/// A file's tree in which angles are the texts that they are written as: "deg(20)".
/// @param tree  with numbers for them
/// @param written  the same text, read without what settings mean by texts
[[nodiscard]] Value withAnglesAsWritten(const Value& tree, const Value& written);

/// The names in a group of settings in the order of config/params.yaml.
[[nodiscard]] std::vector<std::string> documentedOrder(const base::YamlPath& group);

/// A path as requests have it: a list of names and indices.
/// @throws Error for anything else
[[nodiscard]] base::YamlPath pathOf(const Value& list);

}  // namespace synthetic_dataset::programs
