#include "config/object_count.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "config/settings_file.h"

namespace synthetic_dataset::config {
namespace {

using Copies =
    std::map<std::string, std::vector<std::string>>;  ///< by object, for those with copies

/// The number of copies of an object; 1 if its group gives no count or an invalid one.
std::int64_t countOf(Value::Map& settings, const std::string& object) {
  constexpr std::int64_t kMost = 1000;
  Value::Map* group = groupIn(settings, object);
  if (group == nullptr || group->count("count") == 0) return 1;
  const auto* count = group->at("count").as<std::int64_t>();
  return count != nullptr && *count >= 1 && *count <= kMost ? *count : 1;
}

void replaceInList(Value::Map& settings, const Copies& copies) {
  const auto entry = settings.find("robot_list");
  if (entry == settings.end()) return;
  Value::List names;
  if (const auto* list = entry->second.as<Value::List>()) {
    names = *list;
  } else {
    names.push_back(entry->second);
  }
  Value::List replaced;
  for (const Value& each : names) {
    const auto* name = each.as<std::string>();
    const auto found = name == nullptr ? copies.end() : copies.find(*name);
    if (found == copies.end()) {
      replaced.push_back(each);
    } else {
      for (const std::string& copy : found->second) replaced.emplace_back(copy);
    }
  }
  entry->second = Value(std::move(replaced));
}

/// Copies an object's group to each of its copies that does not have its own.
void copyGroups(Value::Map& settings, const Copies& copies) {
  for (const auto& [object, names] : copies) {
    const auto entry = settings.find(object);
    if (entry == settings.end()) continue;
    for (const std::string& name : names) settings.emplace(name, entry->second);
    settings.erase(entry);
  }
}

void copyInMotion(Value::Map& settings, const Copies& copies) {
  replaceInList(settings, copies);
  copyGroups(settings, copies);
  Value::Map* randomize = groupIn(settings, "randomize");
  Value::Map* objects = randomize == nullptr ? nullptr : groupIn(*randomize, "objects");
  if (objects != nullptr) copyGroups(*objects, copies);
}

void numberIds(Value::Map& settings, const Copies& copies) {
  for (const auto& [object, names] : copies) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      Value::Map& group = *groupIn(settings, names[i]);
      group.erase("count");
      const auto id = group.find("id");
      if (id == group.end()) continue;
      if (const auto* number = id->second.as<std::int64_t>()) {
        id->second = Value(*number + static_cast<std::int64_t>(i));
      } else {
        id->second = Value(id->second.text() + "_" + std::to_string(i + 1));
      }
    }
  }
}

}  // namespace

Value::Map withCounts(Value::Map settings) {
  const auto motion = settings.find("motion");
  if (motion == settings.end() || motion->second != Value("placement")) return settings;
  Copies copies;
  const auto list = settings.find("robot_list");
  if (list == settings.end()) return settings;
  const auto* names = list->second.as<Value::List>();
  for (const Value& each : names != nullptr ? *names : Value::List{list->second}) {
    const auto* name = each.as<std::string>();
    const std::int64_t count = name == nullptr ? 1 : countOf(settings, *name);
    for (std::int64_t i = 1; count > 1 && i <= count; ++i) {
      copies[*name].push_back(*name + "_" + std::to_string(i));
    }
  }
  if (copies.empty()) return settings;
  copyInMotion(settings, copies);
  numberIds(settings, copies);
  const auto motions = settings.find("motions");
  auto* entries = motions == settings.end() ? nullptr : motions->second.as<Value::List>();
  if (entries == nullptr) return settings;
  for (Value& entry : *entries) {
    if (auto* group = entry.as<Value::Map>()) copyInMotion(*group, copies);
  }
  return settings;
}

}  // namespace synthetic_dataset::config
