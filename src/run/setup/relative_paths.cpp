#include "run/setup/relative_paths.h"

#include <filesystem>
#include <regex>
#include <set>

namespace synthetic_dataset::run {
namespace {

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

/// The name of the variable of a shell that a path has, "HOME" of "$HOME/x" and "${HOME}/x"; empty:
/// it has none.
std::string shellVariableIn(const std::string& path) {
  static const std::regex kVariable(R"(\$\{?([A-Za-z_][A-Za-z0-9_]*))");
  std::smatch found;
  return std::regex_search(path, found, kVariable) ? found[1].str() : "";
}

}  // namespace

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
      message += "; '" + path + "' starts at the current folder: \"$(dirname)/" + path +
                 "\" would lie beside the settings file";
      break;
    }
  }
  return messages;
}

}  // namespace synthetic_dataset::run
