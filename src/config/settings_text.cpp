#include "config/settings_text.h"

#include <utility>

#include "base/json_text.h"
#include "base/yaml_value.h"

namespace synthetic_dataset::config {
namespace {

void flatten(const std::string& name, const Value& value,
             std::map<std::string, std::string>& flat) {
  const auto* map = value.as<Value::Map>();
  if (map == nullptr) {
    if (!value.isNull()) flat[name] = base::jsonText(value);
    return;
  }
  for (const auto& [key, entry] : *map) flatten(name.empty() ? key : name + "/" + key, entry, flat);
}

void insert(Value::Map& tree, const std::string& name, Value value) {
  const std::size_t slash = name.find('/');
  if (slash == std::string::npos) {
    tree[name] = std::move(value);
    return;
  }
  Value& group = tree[name.substr(0, slash)];
  if (!group.is<Value::Map>()) group = Value::Map{};
  insert(*group.as<Value::Map>(), name.substr(slash + 1), std::move(value));
}

}  // namespace

std::map<std::string, std::string> flatSettings(const Value& tree) {
  std::map<std::string, std::string> flat;
  flatten("", tree, flat);
  return flat;
}

Value settingsTree(const std::map<std::string, std::string>& flat) {
  Value::Map tree;
  for (const auto& [name, text] : flat) {
    insert(tree, name, base::parseYaml(text, "the setting '" + name + "'"));
  }
  return tree;
}

}  // namespace synthetic_dataset::config
