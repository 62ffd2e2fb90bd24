#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/yaml_text/yaml_change.h"
#include "base/yaml_text/yaml_splicer.h"

namespace synthetic_dataset::base {

/// A value to set, or, without one, to remove.
struct YamlChange {
  YamlPath path;
  std::optional<Value> value;
};

/// What a text says, as settings (parseSettings), or, where these may not have what it holds
/// (nothing, dates), as any YAML.
/// @throws Error when it is not YAML
[[nodiscard]] Value readYamlText(const std::string& text, const std::string& origin);

/// Changes a YAML text so that its tree is exactly the old one with the changes, and nothing else
/// of it: comments, order and layout stay. What has an alias elsewhere is changed at its own place
/// alone: the alias becomes the value that it stood for. Where a value cannot be replaced, the
/// smallest entry around it is written anew.
/// @param order  in which new names are put among those that are there
/// @throws Error naming the path when it cannot be done; or as readYamlText
[[nodiscard]] std::string editYaml(const std::string& text, const std::string& origin,
                                   const std::vector<YamlChange>& changes, const NameOrder& order);

}  // namespace synthetic_dataset::base
