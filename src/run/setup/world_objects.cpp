#include "run/setup/world_objects.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/name_pattern.h"
#include "config/config.h"
#include "config/motion_list.h"
#include "config/readers.h"
#include "config/settings_file.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::run {
namespace {

using Names = std::vector<std::string>;

Names namesIn(const Value::Map& settings, const std::string& setting) {
  const auto entry = settings.find(setting);
  if (entry == settings.end()) return {};
  Names names;
  const auto* list = entry->second.as<Value::List>();
  for (const Value& each : list != nullptr ? *list : Value::List{entry->second}) {
    names.push_back(each.text());
  }
  return names;
}

bool has(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Value listOf(const Names& names) { return Value{Value::List(names.begin(), names.end())}; }

/// The models of each motion's world.
/// @throws Error if one cannot be read
std::vector<Names> modelsOfWorlds(const Value& settings, InputCache& inputs) {
  std::vector<Names> all;
  for (const config::MotionEntry& motion : config::readMotions(settings).entries) {
    const config::Config config = config::readConfig(Parameters(motion.settings));
    Names& names = all.emplace_back();
    for (const world::Model& model : inputs.worlds.filesFor(config.world).world().models) {
      names.push_back(model.name);
    }
  }
  return all;
}

/// Why a model's name cannot be that of an object; empty if it can.
std::string whyNoName(const std::string& model, const Value::Map& settings) {
  if (model.find('/') != std::string::npos) return "which has a slash";
  const auto taken = settings.find(model);
  const bool is_setting = taken != settings.end() && !taken->second.is<Value::Map>();
  return is_setting || config::isSettingGroup(model) ? "which is also a setting" : "";
}

class Speller {
 public:
  Speller(const Value::Map& given, std::vector<Names> models)
      : settings_(given), models_(std::move(models)), objects_(namesIn(given, "robot_list")) {
    for (const Names& names : models_) {
      for (const std::string& name : names) {
        if (!has(all_models_, name)) all_models_.push_back(name);
      }
    }
  }

  SpelledWorldObjects spell() {
    const Value::List entries = *settings_.at("world_objects").as<Value::List>();
    for (std::size_t i = 0; i < entries.size(); ++i) {
      addMatching(*entries[i].as<Value::Map>(), "world_objects/" + std::to_string(i));
    }
    if (objects_.empty()) {
      diagnostics_.error("world_objects",
                         "no model of the world matches, and robot_list names no "
                         "object; there should be at least one");
      return {Value(std::move(settings_)), std::move(diagnostics_)};
    }
    settings_.erase("world_objects");
    settings_["robot_list"] = listOf(objects_);
    leaveOutOfOtherWorlds();
    return {Value(std::move(settings_)), std::move(diagnostics_)};
  }

 private:
  void addMatching(const Value::Map& entry, const std::string& name) {
    for (const std::string& pattern : namesIn(entry, "models")) {
      bool is_used = false;
      for (const std::string& model : all_models_) {
        if (!base::matchesPattern(model, pattern)) continue;
        is_used = true;
        add(model, entry, name);
      }
      if (is_used) continue;
      diagnostics_.warning(name + "/models", "nothing in the world is called '" + pattern + "'" +
                                                 didYouMean(pattern, all_models_));
    }
  }

  void add(const std::string& model, const Value::Map& entry, const std::string& name) {
    const auto [before, is_new] = entry_of_.emplace(model, name);
    if (!is_new && before->second != name) {
      diagnostics_.error(name + "/models", "'" + model + "' is in " + before->second +
                                               ", too; each model should be in one");
    }
    if (!is_new || has(objects_, model)) return;  // robot_list takes precedence
    if (const std::string problem = whyNoName(model, settings_); !problem.empty()) {
      diagnostics_.error(name + "/models", "found the model '" + model + "', " + problem +
                                               "; no object can have this name, so the "
                                               "pattern should not match it");
      return;
    }
    Value::Map object = entry;
    object.erase("models");
    object["id"] = Value(model);
    object["pose"] = Value("world");
    if (const Value::Map* own = config::groupIn(settings_, model)) config::overlay(object, *own);
    settings_[model] = Value(std::move(object));
    objects_.push_back(model);
    added_.insert(model);
  }

  /// Excludes each model from the motions whose world lacks it.
  void leaveOutOfOtherWorlds() {
    const auto motions = settings_.find("motions");
    auto* entries = motions == settings_.end() ? nullptr : motions->second.as<Value::List>();
    for (std::size_t i = 0; entries != nullptr && i < entries->size(); ++i) {
      auto* entry = (*entries)[i].as<Value::Map>();
      if (entry == nullptr || i >= models_.size()) continue;
      const Names own = entry->count("robot_list") != 0 ? namesIn(*entry, "robot_list") : objects_;
      Names there;
      for (const std::string& object : objects_) {
        const bool is_added = added_.count(object) != 0;
        if (is_added ? has(models_[i], object) : has(own, object)) there.push_back(object);
      }
      if (there.size() < objects_.size()) (*entry)["robot_list"] = listOf(there);
    }
  }

  Value::Map settings_;
  std::vector<Names> models_;  ///< in each motion's world
  Names all_models_;
  Names objects_;
  std::set<std::string> added_;
  std::map<std::string, std::string> entry_of_;  ///< by model
  base::Diagnostics diagnostics_;
};

}  // namespace

SpelledWorldObjects spellOutWorldObjects(const Value& settings, InputCache& inputs) {
  const auto* given = settings.as<Value::Map>();
  if (given == nullptr || given->count("world_objects") == 0) return {settings, {}};
  Parameters entries(Value(Value::Map{{"world_objects", given->at("world_objects")}}));
  config::checkWorldObjects(entries);
  if (!entries.errors().empty()) return {settings, {}};
  try {
    return Speller(*given, modelsOfWorlds(settings, inputs)).spell();
  } catch (const Error&) {
    return {settings, {}};
  }
}

}  // namespace synthetic_dataset::run
