#include "config/checked_values.h"

#include <cstdlib>
#include <filesystem>

namespace synthetic_dataset::config {

double numberAbove(const Parameters& group, const std::string& name, double fallback,
                   double limit) {
  const double number = group.optional(name, fallback);
  if (number > limit) return number;
  group.addError(name,
                 "found " + Value(number).text() + "; it should be above " + Value(limit).text());
  return fallback;
}

int numberBetween(const Parameters& group, const std::string& name, int fallback, int low,
                  int high) {
  const int number = group.optional(name, fallback);
  if (number >= low && number <= high) return number;
  group.addError(name, "found " + std::to_string(number) + "; it should be " + std::to_string(low) +
                           " to " + std::to_string(high));
  return fallback;
}

std::optional<double> maybeSeconds(const Parameters& group, const std::string& name) {
  constexpr double kLongest = 1e9;
  const auto number = group.maybe<double>(name);
  if (number && (*number < 0.0 || *number > kLongest)) {
    group.addError(name, "found " + Value(*number).text() + " s; it should be 0 to 1e9");
    return std::nullopt;
  }
  return number;
}

std::string absolutePath(const std::string& path) {
  if (path.empty()) return path;
  std::filesystem::path result = path;
  const char* home = std::getenv("HOME");
  if (home != nullptr && path.rfind("~/", 0) == 0) {
    result = std::filesystem::path(home) / path.substr(2);
  }
  return std::filesystem::absolute(result).lexically_normal().string();
}

std::string folderPath(const std::string& path) {
  std::string result = absolutePath(path);
  if (!result.empty() && result.back() != '/') result += '/';
  return result;
}

std::string pathOrUri(const std::string& text) {
  return text.find("://") == std::string::npos ? absolutePath(text) : text;
}

bool isEmptyList(const Parameters& group, const std::string& name) {
  const auto given = group.maybe<Value>(name);
  const auto* list = given ? given->as<Value::List>() : nullptr;
  return list != nullptr && list->empty();
}

}  // namespace synthetic_dataset::config
