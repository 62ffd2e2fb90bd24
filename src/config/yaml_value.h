#pragma once

#include <string>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::config {

/// Reads YAML text as roslaunch's `<rosparam>` does (PyYAML, YAML 1.1): 010 is 8, yes is true,
/// "007" is a text.
/// @param origin  for messages, usually the file's name
/// @throws Error "<origin>: line 3: ..." when it is no YAML, or nests too deep
[[nodiscard]] Value parseYaml(const std::string& text, const std::string& origin);

/// parseYaml of a file's content.
/// @throws Error also when the file cannot be read
[[nodiscard]] Value loadYamlFile(const std::string& file);

}  // namespace synthetic_dataset::config
