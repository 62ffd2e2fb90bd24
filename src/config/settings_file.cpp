#include "config/settings_file.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include "base/input_file.h"
#include "base/yaml_value.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::config {
namespace {

using Path = std::vector<std::string>;

/// Appends a name's parts; repeated and trailing slashes are ignored, as in ROS names.
Path withName(Path path, const std::string& name) {
  std::istringstream stream(name);
  for (std::string part; std::getline(stream, part, '/');) {
    if (!part.empty()) path.push_back(part);
  }
  return path;
}

std::string textOf(const Path& path) {
  std::string text;
  for (const std::string& part : path) text += (text.empty() ? "" : "/") + part;
  return text;
}

/// Builds the parameter server's tree, value by value.
class ParameterTree {
 public:
  explicit ParameterTree(const std::string& origin) : origin_(origin) {}

  void add(const Path& path, const Value& value) {
    const auto* group = value.as<Value::Map>();
    if (group == nullptr) return set(path, value);
    for (const auto& [name, entry] : *group) {
      if (name == "/robot_list") {
        global_robot_list_ = entry;
      } else if (withName({}, name).empty() || name[0] == '/' || name[0] == '~') {
        throw Error(origin_ + ": found the name '" + textOf(path) + (path.empty() ? "" : "/") +
                    name + "'; it should be the node's own, such as yolo/main_list");
      } else {
        add(withName(path, name), entry);
      }
    }
  }

  Value::Map take() {
    if (global_robot_list_ && tree_.count("robot_list") == 0) {
      tree_["robot_list"] = *global_robot_list_;
    }
    return std::move(tree_);
  }

 private:
  void set(const Path& path, const Value& value) {
    Value::Map* group = &tree_;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      Value& next = group->emplace(path[i], Value::Map{}).first->second;
      group = next.as<Value::Map>();
      if (group == nullptr) {
        throw Error(origin_ + ": found '" + textOf(path) + "', but '" +
                    textOf({path.begin(), path.begin() + static_cast<std::ptrdiff_t>(i) + 1}) +
                    "' has a value of its own");
      }
    }
    if (!group->emplace(path.back(), value).second) {
      throw Error(origin_ + ": '" + textOf(path) + "' is given twice");
    }
  }

  const std::string& origin_;
  Value::Map tree_;
  std::optional<Value> global_robot_list_;
};

/// Converts line ends of Windows and old Macs to `\n`, as Python's text mode does.
std::string withPlainLineEnds(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\r') {
      result += text[i];
    } else if (i + 1 == text.size() || text[i + 1] != '\n') {
      result += '\n';
    }
  }
  return result;
}

/// Removes the setting `include` and returns the file names in it.
std::vector<std::string> takeIncluded(Value::Map& settings, const std::string& file) {
  const auto entry = settings.find("include");
  if (entry == settings.end()) return {};
  const Value given = entry->second;
  settings.erase(entry);
  if (const auto* name = given.as<std::string>()) return {*name};
  std::vector<std::string> names;
  const auto* list = given.as<Value::List>();
  for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
    if (const auto* name = (*list)[i].as<std::string>()) names.push_back(*name);
  }
  if (list != nullptr && names.size() == list->size()) return names;
  throw Error(file + ": include: found " + given.text() +
              "; it should be the name of a settings file, or a list of names");
}

bool holdsAny(const Value::Map& group, const std::set<std::string>& names) {
  return std::any_of(group.begin(), group.end(),
                     [&](const auto& entry) { return names.count(entry.first) != 0; });
}

/// Whether a group gives the distribution of a setting, instead of containing settings.
bool isDistribution(const Value::Map& group) {
  static const std::set<std::string> kKinds = {"uniform", "log_uniform", "normal", "choice"};
  return holdsAny(group, kKinds);
}

/// Whether a group replaces the one below instead of being merged with it: a distribution does, but
/// only weights or limits may be merged into one.
bool replaces(const Value::Map& over, const Value::Map& below) {
  static const std::set<std::string> kBeside = {"weights", "min", "max"};
  return isDistribution(over) || (isDistribution(below) && !holdsAny(over, kBeside));
}

Value::Map loadOver(const std::string& file, const SettingsSources& sources,
                    const base::Remark& remark, std::vector<std::string> above) {
  std::error_code problem;  // ignored: reading the file reports it
  const std::string place = std::filesystem::weakly_canonical(file, problem).string();
  if (std::find(above.begin(), above.end(), place) != above.end()) {
    throw Error(file + ": include: found a file that includes itself");
  }
  if (!above.empty()) sources.admit(file);
  above.push_back(place);
  const std::string bytes = base::readInput(file);
  const std::string fault = base::textFault(bytes);
  if (!fault.empty()) throw Error(file + ": " + fault);
  const std::string text = withPlainLineEnds(bytes);
  Value::Map own = asParameters(
      base::parseSettings(substitute(text, {file, sources.package_folder, sources.environment}),
                          file, remark),
      file);
  Value::Map settings;
  for (const std::string& name : takeIncluded(own, file)) {
    const auto folder = std::filesystem::path(file).parent_path();
    overlay(settings, loadOver((folder / name).string(), sources, remark, above));
  }
  overlay(settings, own);
  return settings;
}

}  // namespace

Value::Map loadSettings(const std::string& file, const SettingsSources& sources,
                        const base::Remark& remark) {
  return loadOver(file, sources, remark, {});
}

Value::Map loadSettings(const std::string& file, const TextFinder& package_folder,
                        const base::Remark& remark) {
  SettingsSources sources;
  sources.package_folder = package_folder;
  return loadSettings(file, sources, remark);
}

Value::Map asParameters(const Value& tree, const std::string& origin) {
  if (tree.isNull()) return {};  // an empty file
  if (!tree.is<Value::Map>()) {
    throw Error(origin + ": found " + tree.kind() + "; it should be a group of named values");
  }
  ParameterTree parameters(origin);
  parameters.add({}, tree);
  return parameters.take();
}

void overlay(Value::Map& settings, const Value::Map& over) {
  for (const auto& [name, value] : over) {
    Value& below = settings[name];
    const auto* group = value.as<Value::Map>();
    if (group == nullptr) {
      below = value;
    } else {
      const auto* group_below = below.as<Value::Map>();
      if (group_below == nullptr || replaces(*group, *group_below)) below = Value::Map{};
      overlay(*below.as<Value::Map>(), *group);
    }
  }
}

void overrideBy(const Value::Map& over, Value::Map& settings) {
  if (over.count("output_folder") != 0) {
    for (auto& [name, value] : settings) {
      auto* group = value.as<Value::Map>();
      if (group != nullptr) group->erase("output_folder");
    }
  }
  overlay(settings, over);
}

Value::Map* groupIn(Value::Map& settings, const std::string& name) {
  const auto entry = settings.find(name);
  return entry == settings.end() ? nullptr : entry->second.as<Value::Map>();
}

const Value::Map* groupIn(const Value::Map& settings, const std::string& name) {
  const auto entry = settings.find(name);
  return entry == settings.end() ? nullptr : entry->second.as<Value::Map>();
}

Value::Map settingOf(const std::string& name, const std::string& text) {
  const std::string origin = name + ":=" + text;
  const Value value = base::parseSettings(text, origin);
  if (value.isNull()) throw Error(origin + ": found nothing; it should have a value");
  return asParameters(Value::Map{{name, value}}, origin);
}

}  // namespace synthetic_dataset::config
