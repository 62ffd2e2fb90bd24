#include "config/motion_list.h"

#include <algorithm>
#include <utility>

#include "config/checked_values.h"
#include "config/motion_overlay.h"
#include "config/settings_file.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::config {
namespace {

const std::set<std::string>& settingsOfEntries() {
  static const std::set<std::string> kNames = {"name", "weight", "split", "robot_list"};
  return kNames;
}

std::string withoutLeadingSlash(const std::string& name) {
  return !name.empty() && name.front() == '/' ? name.substr(1) : name;
}

/// The objects that the run names; readObjects() reports anything other than names.
std::set<std::string> objectsOf(const Value::Map& run) {
  std::set<std::string> objects;
  const auto entry = run.find("robot_list");
  if (entry == run.end()) return objects;
  if (const auto* list = entry->second.as<Value::List>()) {
    for (const Value& each : *list) {
      if (const auto* name = each.as<std::string>()) objects.insert(withoutLeadingSlash(*name));
    }
  } else if (const auto* name = entry->second.as<std::string>()) {
    objects.insert(withoutLeadingSlash(*name));
  }
  return objects;
}

bool isPlacement(const Value::Map& settings) {
  const auto entry = settings.find("motion");
  return entry != settings.end() && entry->second == Value("placement");
}

/// The only motion of a run whose list is wrong. With a list, even a recording's run may have
/// `scenes`, so it is removed here.
MotionEntry withoutMotions(const Value::Map& run) {
  Value::Map settings = run;
  settings.erase("motions");
  if (!isPlacement(run)) settings.erase("scenes");
  return {"", "0", 1.0, {}, {}, {}, Value(std::move(settings))};
}

/// Reads the entries one by one.
class Reader {
 public:
  explicit Reader(const Value::Map& run) : run_(run), objects_(objectsOf(run)), all_(Value(run)) {}

  MotionList read(const Value::List& given) {
    readTotal();
    if (given.empty()) error("motions: found an empty list; it should have at least one motion");
    for (std::size_t i = 0; i < given.size(); ++i) readEntry(given[i], i);
    if (list_.entries.empty()) list_.entries.push_back(withoutMotions(run_));
    checkNames();
    checkAllTakePart();
    layOver();
    return std::move(list_);
  }

 private:
  void error(const std::string& message) { list_.errors.push_back(message); }

  /// Next to the list, `scenes` is the number of scenes of all motions together.
  void readTotal() {
    if (run_.count("scenes") == 0) return;
    list_.is_weighted = true;
    list_.scenes = maybeSceneCount(all_, "scenes");
    for (const std::string& message : all_.errors()) error(message);
  }

  void readEntry(const Value& given, std::size_t index) {
    MotionEntry entry;
    entry.group = "motions/" + std::to_string(index);
    entry.name = std::to_string(index);
    if (!given.is<Value::Map>()) {
      error(entry.group + ": found " + given.kind() +
            "; it should be a group of settings, such as {bag_file: walk.bag}");
      return;
    }
    try {
      entry.own = asParameters(given, entry.group);
    } catch (const Error& problem) {
      error(problem.what());
      return;
    }
    Parameters group(Value(entry.own), entry.group);
    entry.name = readName(group).value_or(entry.name);
    entry.weight = readWeight(group);
    entry.split = readSplitName(group);
    readObjects(group, entry);
    for (const std::string& message : group.errors()) error(message);
    checkSettings(entry);
    list_.entries.push_back(std::move(entry));
  }

  static std::optional<std::string> readName(Parameters& group) {
    auto name = group.maybe<std::string>("name");
    if (name && (name->empty() || name->find_first_of("\n\r") != std::string::npos)) {
      group.addError("name", "found '" + *name + "'; it should be a text of one line");
      return std::nullopt;
    }
    return name;
  }

  double readWeight(Parameters& group) {
    const auto weight = group.maybe<double>("weight");
    if (!weight) return 1.0;
    list_.is_weighted = true;
    if (*weight > 0.0) return *weight;
    group.addError("weight", "found " + Value(*weight).text() +
                                 "; it should be above 0: the motion's share of the scenes, "
                                 "beside the others' weights");
    return 1.0;
  }

  static std::optional<std::string> readSplitName(Parameters& group) {
    return group.maybeChoice("split", {"train", "val", "test"});
  }

  void readObjects(Parameters group, MotionEntry& entry) const {
    const auto names = group.maybe<std::vector<std::string>>("robot_list");
    if (!names) return;
    if (names->empty()) {
      group.addError("robot_list",
                     "found an empty list; it should name the objects that take part");
    }
    for (const std::string& given : *names) {
      const std::string name = withoutLeadingSlash(given);
      if (objects_.count(name) != 0) {
        entry.objects.insert(name);
        continue;
      }
      group.addError("robot_list", "found '" + name +
                                       "', which the run's robot_list does not have; it should "
                                       "name all objects of all motions" +
                                       didYouMean(name, {objects_.begin(), objects_.end()}));
    }
  }

  /// Settings that do not belong to one motion belong to the whole dataset.
  void checkSettings(const MotionEntry& entry) {
    for (const auto& [name, value] : entry.own) {
      if (settingsOfEntries().count(name) != 0 || settingsOfMotions().count(name) != 0) continue;
      if (objects_.count(name) != 0) {
        checkObject(entry.group + "/" + name, value);
      } else if (run_.count(name) != 0 || name == "seed" || name == "global_frame") {
        error(entry.group + "/" + name +
              ": is a setting of the whole dataset; it should stand beside motions");
      } else {
        error(entry.group + "/" + name + ": unknown parameter" + didYouMean(name, known()));
      }
    }
  }

  [[nodiscard]] static std::vector<std::string> known() {
    std::vector<std::string> names(settingsOfMotions().begin(), settingsOfMotions().end());
    names.insert(names.end(), settingsOfEntries().begin(), settingsOfEntries().end());
    return names;
  }

  void checkObject(const std::string& group, const Value& value) {
    const auto* settings = value.as<Value::Map>();
    if (settings == nullptr) {
      error(group + ": found " + value.kind() + "; it should be a group of settings");
      return;
    }
    const std::set<std::string>& moved = settingsOfMovedObjects();
    for (const auto& [name, setting] : *settings) {
      if (moved.count(name) != 0) continue;
      error(group + "/" + name +
            ": an object is the same in all motions, but for frame, frame_id, link_frames, "
            "safety_radius and when_unknown; it should stand in the run's group '" +
            group.substr(group.rfind('/') + 1) + "'");
    }
  }

  void checkNames() {
    std::set<std::string> names;
    for (const MotionEntry& entry : list_.entries) {
      if (names.insert(entry.name).second) continue;
      error(entry.group + "/name: found '" + entry.name +
            "' more than once; each motion should have its own");
    }
  }

  void checkAllTakePart() {
    for (const std::string& name : objects_) {
      const bool takes_part =
          std::any_of(list_.entries.begin(), list_.entries.end(), [&](const MotionEntry& entry) {
            return entry.objects.empty() || entry.objects.count(name) != 0;
          });
      if (takes_part) continue;
      error("robot_list: found '" + name + "', which no motion's robot_list has");
    }
  }

  /// Overlays the run's settings with each entry's. If the list has both kinds of motion, the run's
  /// settings for one kind apply only to entries of that kind.
  void layOver() {
    bool has_bags = false;
    bool has_placements = false;
    for (const MotionEntry& entry : list_.entries) {
      (isPlacement(settingsOf(entry)) ? has_placements : has_bags) = true;
    }
    for (MotionEntry& entry : list_.entries) {
      if (entry.group.empty()) continue;
      Value::Map below = run_;
      below.erase("motions");
      below.erase("scenes");
      if (has_bags && has_placements) {
        const bool is_placed = isPlacement(settingsOf(entry));
        for (const char* name : {"start_offset", "duration", "max_tf_gap", "stretch", "tf_topics",
                                 "pose_topics", "when_unknown"}) {
          if (is_placed) below.erase(name);
        }
        if (!is_placed) below.erase("placement");
      }
      Value::Map own;  // the rest is about the entry, or already an error
      for (const auto& [name, value] : entry.own) {
        const bool is_of_motion = settingsOfMotions().count(name) != 0;
        if (is_of_motion || objects_.count(name) != 0) own.emplace(name, value);
      }
      overlayMotion(below, own, objects_);
      placeAsManyAsNeeded(below);
      entry.settings = Value(std::move(below));
    }
  }

  /// The settings that determine which kind of motion an entry is.
  [[nodiscard]] Value::Map settingsOf(const MotionEntry& entry) const {
    Value::Map settings = run_;
    overlay(settings, entry.own);
    return settings;
  }

  /// Random placement can provide as many scenes as needed.
  void placeAsManyAsNeeded(Value::Map& settings) const {
    if (!list_.scenes || !isPlacement(settings) || settings.count("scenes") != 0) return;
    settings["scenes"] = Value(*list_.scenes);
  }

  const Value::Map& run_;
  std::set<std::string> objects_;
  Parameters all_;
  MotionList list_;
};

/// Whether settings contain one with this full name.
bool has(const Value::Map& settings, const std::string& full_name) {
  const std::size_t slash = full_name.find('/');
  const auto entry = settings.find(full_name.substr(0, slash));
  if (entry == settings.end()) return false;
  const auto* group = entry->second.as<Value::Map>();
  return slash == std::string::npos || group == nullptr || has(*group, full_name.substr(slash + 1));
}

}  // namespace

bool MotionEntry::says(const std::string& full_name) const { return has(own, full_name); }

MotionList readMotions(const Value& parameters) {
  MotionList only;
  only.entries.push_back({"", "0", 1.0, {}, {}, {}, parameters});
  const auto* run = parameters.as<Value::Map>();
  const auto motions = run == nullptr ? Value::Map::const_iterator{} : run->find("motions");
  if (run == nullptr || motions == run->end()) return only;
  const auto* given = motions->second.as<Value::List>();
  if (given != nullptr) return Reader(*run).read(*given);
  only.errors.push_back("motions: found " + motions->second.kind() +
                        "; it should be a list of groups of settings, one for each motion");
  only.entries.front() = withoutMotions(*run);
  return only;
}

}  // namespace synthetic_dataset::config
