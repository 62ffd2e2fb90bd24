#include "base/yaml_text/yaml_change.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/yaml_text/yaml_rendering.h"
#include "base/yaml_value.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace {

std::optional<double> numberOf(const Value& value) {
  if (const auto* whole = value.as<std::int64_t>()) return static_cast<double>(*whole);
  if (const auto* number = value.as<double>()) return *number;
  const auto* text = value.as<std::string>();
  if (text == nullptr || !isAngleText(*text)) return std::nullopt;
  try {
    return numberOf(parseSettings(*text, ""));
  } catch (const Error&) {  // reported where the settings are read
    return std::nullopt;
  }
}

bool isNothing(const Value& value) {
  const auto* map = value.as<Value::Map>();
  return value.isNull() || (map != nullptr && map->empty());
}

const Value* childOf(const Value& value, const YamlStep& step) {
  const auto* map = value.as<Value::Map>();
  if (const auto* name = std::get_if<std::string>(&step); name != nullptr && map != nullptr) {
    const auto found = map->find(*name);
    return found == map->end() ? nullptr : &found->second;
  }
  const auto* list = value.as<Value::List>();
  const auto* index = std::get_if<std::size_t>(&step);
  return index != nullptr && list != nullptr && *index < list->size() ? &(*list)[*index] : nullptr;
}

void setFrom(Value& tree, const YamlPath& path, std::size_t depth, const Value& value) {
  if (depth == path.size()) {
    tree = value;
    return;
  }
  if (const auto* name = std::get_if<std::string>(&path[depth])) {
    if (!tree.is<Value::Map>()) tree = Value::Map{};
    setFrom((*tree.as<Value::Map>())[*name], path, depth + 1, value);
    return;
  }
  const std::size_t index = std::get<std::size_t>(path[depth]);
  if (!tree.is<Value::List>()) tree = Value::List{};
  auto& list = *tree.as<Value::List>();
  if (index > list.size()) {
    throw Error(pathText(path) + ": found the index " + std::to_string(index) + "; the list has " +
                std::to_string(list.size()) + " entries");
  }
  if (index == list.size()) list.emplace_back();
  setFrom(list[index], path, depth + 1, value);
}

/// Removes the entry at a path, and the maps around it that are then empty.
void removeFrom(Value& tree, const YamlPath& path, std::size_t depth) {
  const auto* name = std::get_if<std::string>(&path[depth]);
  if (auto* map = tree.as<Value::Map>(); map != nullptr && name != nullptr) {
    const auto found = map->find(*name);
    if (found == map->end()) return;
    if (depth + 1 < path.size()) {
      removeFrom(found->second, path, depth + 1);
      const auto* inner = found->second.as<Value::Map>();
      if (inner == nullptr || !inner->empty()) return;
    }
    map->erase(found);
  } else if (auto* list = tree.as<Value::List>(); list != nullptr && name == nullptr) {
    const std::size_t index = std::get<std::size_t>(path[depth]);
    if (index >= list->size()) return;
    if (depth + 1 < path.size()) return removeFrom((*list)[index], path, depth + 1);
    list->erase(list->begin() + static_cast<std::ptrdiff_t>(index));
  }
}

void compare(const Value& a, const Value& b, YamlPath& path, std::vector<YamlPath>& differing) {
  const auto* map_a = a.as<Value::Map>();
  const auto* map_b = b.as<Value::Map>();
  const auto* list_a = a.as<Value::List>();
  const auto* list_b = b.as<Value::List>();
  if (map_a != nullptr && map_b != nullptr) {
    std::set<std::string> names;
    for (const auto& each : *map_a) names.insert(each.first);
    for (const auto& each : *map_b) names.insert(each.first);
    for (const std::string& name : names) {
      path.emplace_back(name);
      const Value* in_a = childOf(a, path.back());
      const Value* in_b = childOf(b, path.back());
      if (in_a == nullptr || in_b == nullptr) {
        differing.push_back(path);
      } else {
        compare(*in_a, *in_b, path, differing);
      }
      path.pop_back();
    }
  } else if (list_a != nullptr && list_b != nullptr && list_a->size() == list_b->size()) {
    for (std::size_t i = 0; i < list_a->size(); ++i) {
      path.emplace_back(i);
      compare((*list_a)[i], (*list_b)[i], path, differing);
      path.pop_back();
    }
  } else if (!saysTheSame(a, b)) {
    differing.push_back(path);
  }
}

}  // namespace

std::string pathText(const YamlPath& path) {
  std::string text;
  for (const YamlStep& step : path) {
    const auto* name = std::get_if<std::string>(&step);
    text += (text.empty() ? "" : "/") +
            (name != nullptr ? *name : std::to_string(std::get<std::size_t>(step)));
  }
  return text;
}

const Value* valueAt(const Value& tree, const YamlPath& path) {
  const Value* value = &tree;
  for (const YamlStep& step : path) {
    value = childOf(*value, step);
    if (value == nullptr) return nullptr;
  }
  return value;
}

void setValue(Value& tree, const YamlPath& path, const Value& value) {
  setFrom(tree, path, 0, value);
}

void removeValue(Value& tree, const YamlPath& path) {
  if (!path.empty()) removeFrom(tree, path, 0);
}

bool saysTheSame(const Value& a, const Value& b) {
  if (a.is<std::int64_t>() && b.is<std::int64_t>()) return a == b;
  const auto number_a = numberOf(a);
  const auto number_b = numberOf(b);
  if (number_a && number_b) {
    return *number_a == *number_b || (std::isnan(*number_a) && std::isnan(*number_b));
  }
  if (isNothing(a) && isNothing(b)) return true;
  const auto* map_a = a.as<Value::Map>();
  const auto* map_b = b.as<Value::Map>();
  if (map_a != nullptr && map_b != nullptr) {
    return map_a->size() == map_b->size() &&
           std::equal(map_a->begin(), map_a->end(), map_b->begin(),
                      [](const auto& x, const auto& y) {
                        return x.first == y.first && saysTheSame(x.second, y.second);
                      });
  }
  const auto* list_a = a.as<Value::List>();
  const auto* list_b = b.as<Value::List>();
  if (list_a != nullptr && list_b != nullptr) {
    return list_a->size() == list_b->size() &&
           std::equal(list_a->begin(), list_a->end(), list_b->begin(), saysTheSame);
  }
  return a == b;
}

std::vector<YamlPath> differences(const Value& a, const Value& b) {
  std::vector<YamlPath> differing;
  YamlPath path;
  compare(a, b, path, differing);
  return differing;
}

}  // namespace synthetic_dataset::base
