#include "run/setup/setup_errors.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include "config/config.h"

namespace synthetic_dataset::run {
namespace {

bool holds(const std::vector<std::string>& messages, const std::string& message) {
  return std::find(messages.begin(), messages.end(), message) != messages.end();
}

std::string inGroup(const std::string& group, const std::string& message) {
  return group.empty() ? message : group + ": " + message;
}

/// The entries of the first list that are also in all others.
std::vector<std::string> commonTo(const std::vector<std::vector<std::string>>& lists) {
  std::vector<std::string> common;
  for (const std::string& each : lists.front()) {
    const bool is_everywhere = std::all_of(lists.begin(), lists.end(),
                                           [&](const auto& list) { return holds(list, each); });
    if (is_everywhere && !holds(common, each)) common.push_back(each);
  }
  return common;
}

/// All texts of the settings that may be relative paths.
void collectPaths(const Value& value, std::set<std::string>& paths) {
  if (const auto* map = value.as<Value::Map>()) {
    for (const auto& [name, entry] : *map) collectPaths(entry, paths);
  } else if (const auto* list = value.as<Value::List>()) {
    for (const Value& entry : *list) collectPaths(entry, paths);
  } else if (const auto* text = value.as<std::string>()) {
    constexpr std::size_t kLongest = 1000;
    const bool is_relative = !text->empty() && text->front() != '/' && text->front() != '~' &&
                             text->find("://") == std::string::npos &&
                             text->find('\n') == std::string::npos && text->size() < kLongest;
    if (is_relative && text->find_first_of("./") != std::string::npos) paths.insert(*text);
  }
}

/// The name of the shell variable in a path, "HOME" for "$HOME/x" and "${HOME}/x"; empty if there
/// is none.
std::string shellVariableIn(const std::string& path) {
  static const std::regex kVariable(R"(\$\{?([A-Za-z_][A-Za-z0-9_]*))");
  std::smatch found;
  return std::regex_search(path, found, kVariable) ? found[1].str() : "";
}

/// Whether settings have an entry such as "randomize/room/size" or, in a list, "motions/2".
bool hasEntry(const Value& settings, const std::string& path) {
  const std::size_t end = path.find('/');
  const std::string name = path.substr(0, end);
  const Value* entry = nullptr;
  if (const auto* map = settings.as<Value::Map>()) {
    const auto found = map->find(name);
    if (found != map->end()) entry = &found->second;
  } else if (const auto* list = settings.as<Value::List>()) {
    const bool is_index =
        !name.empty() && name.size() < 4 &&
        std::all_of(name.begin(), name.end(), [](char each) { return each >= '0' && each <= '9'; });
    if (is_index && std::stoul(name) < list->size()) entry = &(*list)[std::stoul(name)];
  }
  return entry != nullptr && (end == std::string::npos || hasEntry(*entry, path.substr(end + 1)));
}

}  // namespace

std::vector<std::string> mergedErrors(const std::vector<MotionErrors>& motions) {
  std::vector<std::vector<std::string>> lists;
  for (const MotionErrors& motion : motions) lists.push_back(motion.messages);
  std::vector<std::string> errors = commonTo(lists);
  const std::size_t common = errors.size();
  for (const MotionErrors& motion : motions) {
    for (const std::string& message : motion.messages) {
      const auto end = errors.begin() + static_cast<std::ptrdiff_t>(common);
      if (std::find(errors.begin(), end, message) != end) continue;
      errors.push_back(inGroup(motion.group, message));
    }
  }
  return errors;
}

std::vector<std::string> unusedSettings(const std::vector<config::MotionEntry>& entries,
                                        const std::vector<Parameters>& roots) {
  std::vector<std::vector<std::string>> unused;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    unused.emplace_back();
    for (const std::string& name : roots[i].unknownNames()) {
      if (!entries[i].says(name)) unused.back().push_back(name);
    }
  }
  return commonTo(unused);
}

std::vector<std::string> unknownParameters(const std::vector<config::MotionEntry>& entries,
                                           const std::vector<Parameters>& roots) {
  const std::vector<std::string> of_all = unusedSettings(entries, roots);
  std::vector<std::string> errors;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    std::vector<std::string> own;
    for (const std::string& name : roots[i].unknownNames()) {
      if (entries[i].says(name)) own.push_back(name);
    }
    for (const std::string& message : config::unknownParameterErrors(roots[i], own)) {
      errors.push_back(inGroup(entries[i].group, message));
    }
  }
  const auto common = config::unknownParameterErrors(roots.front(), of_all);
  errors.insert(errors.begin(), common.begin(), common.end());
  return errors;
}

std::vector<std::string> explainRelativePaths(std::vector<std::string> messages,
                                              const Value& settings) {
  std::set<std::string> paths;
  collectPaths(settings, paths);
  for (std::string& message : messages) {
    if (message.find("no such file") == std::string::npos) continue;
    for (const std::string& path : paths) {
      const std::string absolute = std::filesystem::absolute(path).lexically_normal().string();
      if (message.find(absolute) == std::string::npos) continue;
      const std::string variable = shellVariableIn(path);
      if (!variable.empty()) {
        message += "; in settings, $(env " + variable + ") is what a shell calls $" + variable;
        break;
      }
      message += "; '" + path + "' is relative to the current folder: \"$(dirname)/" + path +
                 "\" would be beside the settings file";
      break;
    }
  }
  return messages;
}

std::vector<std::string> explainPreset(std::vector<std::string> messages, const Value& given,
                                       const Value& spelled) {
  for (std::string& message : messages) {
    const std::string path = message.substr(0, message.find(": "));
    // Errors shared by all motions are reported without a group.
    const bool is_spelled = hasEntry(spelled, path) || hasEntry(spelled, "motions/0/" + path);
    if (is_spelled && !hasEntry(given, path)) {
      message += "; `" + path + "` comes from `randomize: {preset: transfer}`";
    }
  }
  return messages;
}

}  // namespace synthetic_dataset::run
