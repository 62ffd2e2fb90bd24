#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/yaml_text/yaml_change.h"
#include "base/yaml_text/yaml_splicer.h"

namespace synthetic_dataset::base {

/// A value to set or, if nullopt, to remove.
struct YamlChange {
  YamlPath path;
  std::optional<Value> value;
};

/// Reads a text as settings (parseSettings) or, if it contains what settings cannot hold (null,
/// dates), as any YAML.
/// @throws Error if it is not YAML
[[nodiscard]] Value readYamlText(const std::string& text, const std::string& origin);

/// Changes a YAML text so that its tree is exactly the old one with the changes; all else in the
/// text, comments, order and layout, stays. A value that has an alias elsewhere is changed only at
/// its own place: the alias is replaced by the value that it stood for. If a value cannot be
/// replaced, the smallest entry around it is rewritten.
/// @param order  in which new names are placed among the existing ones
/// @throws Error naming the path if it cannot be done; or as readYamlText
[[nodiscard]] std::string editYaml(const std::string& text, const std::string& origin,
                                   const std::vector<YamlChange>& changes, const NameOrder& order);

}  // namespace synthetic_dataset::base
