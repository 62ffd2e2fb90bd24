#include "programs/setup_assistant/document/settings_names.h"

#include <map>

#include "base/yaml_text/yaml_rendering.h"
#include "config/settings_file.h"
#include "programs/settings/documented_settings.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace {

/// The names directly in each group, by the group's name followed by a slash.
std::map<std::string, std::vector<std::string>> namesByGroup() {
  std::map<std::string, std::vector<std::string>> names;
  for (const DocumentedSetting& each : documentedSettings()) {
    const std::size_t slash = each.path.rfind('/');
    const std::size_t start = slash == std::string::npos ? 0 : slash + 1;
    names[each.path.substr(0, start)].push_back(each.path.substr(start));
  }
  return names;
}

/// How many steps of a path a name in a map covers; 0 if it does not match.
std::size_t stepsOfName(const base::YamlPath& path, std::size_t from, const std::string& name) {
  std::string joined;
  for (std::size_t i = from; i < path.size(); ++i) {
    const auto* step = std::get_if<std::string>(&path[i]);
    if (step == nullptr) return 0;
    joined += (i == from ? "" : "/") + *step;
    if (joined == name || "/" + joined == name) return i + 1 - from;
  }
  return 0;
}

}  // namespace

base::YamlPath pathAsWritten(const base::YamlPath& path, const Value& tree) {
  base::YamlPath written;
  const Value* value = &tree;
  for (std::size_t i = 0; i < path.size();) {
    std::size_t steps = 1;
    base::YamlStep step = path[i];
    if (const auto* map = value == nullptr ? nullptr : value->as<Value::Map>()) {
      for (const auto& each : *map) {
        const std::size_t count = stepsOfName(path, i, each.first);
        if (count == 0 || (count == steps && each.first != std::get<std::string>(path[i]) &&
                           map->count(std::get<std::string>(path[i])) != 0)) {
          continue;
        }
        steps = count;
        step = each.first;
      }
    }
    value = value == nullptr ? nullptr : base::valueAt(*value, {step});
    written.push_back(step);
    i += steps;
  }
  return written;
}

Value asGroups(const Value& tree, const std::string& origin) {
  try {
    return config::asParameters(tree, origin);
  } catch (const Error&) {
    return tree;
  }
}

Value withAnglesAsWritten(const Value& tree, const Value& written) {
  const auto* text = written.as<std::string>();
  if (text != nullptr && base::isAngleText(*text)) return written;
  Value result = tree;
  if (auto* map = result.as<Value::Map>()) {
    const auto* other = written.as<Value::Map>();
    for (auto& [name, value] : *map) {
      const auto found = other == nullptr ? Value::Map::const_iterator() : other->find(name);
      if (other == nullptr || found == other->end()) continue;
      value = withAnglesAsWritten(value, found->second);
    }
  } else if (auto* list = result.as<Value::List>()) {
    const auto* other = written.as<Value::List>();
    if (other == nullptr || other->size() != list->size()) return result;
    for (std::size_t i = 0; i < list->size(); ++i) {
      (*list)[i] = withAnglesAsWritten((*list)[i], (*other)[i]);
    }
  }
  return result;
}

std::vector<std::string> documentedOrder(const base::YamlPath& group) {
  static const auto kNames = namesByGroup();
  std::string name;
  for (const base::YamlStep& step : group) {
    const auto* text = std::get_if<std::string>(&step);
    name += (text != nullptr ? *text : "-") + "/";
  }
  const auto found = kNames.find(name);
  return found == kNames.end() ? std::vector<std::string>() : found->second;
}

base::YamlPath pathOf(const Value& list) {
  base::YamlPath path;
  const auto* steps = list.as<Value::List>();
  for (std::size_t i = 0; steps != nullptr && i < steps->size(); ++i) {
    const Value& step = (*steps)[i];
    if (const auto* name = step.as<std::string>()) {
      path.emplace_back(*name);
    } else if (const auto* index = step.as<std::int64_t>(); index != nullptr && *index >= 0) {
      path.emplace_back(static_cast<std::size_t>(*index));
    }
  }
  if (steps != nullptr && !path.empty() && path.size() == steps->size()) return path;
  throw Error("path: found " + list.text() + "; it should be a list of names and indices");
}

}  // namespace synthetic_dataset::programs
