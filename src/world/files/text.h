#pragma once

#include <algorithm>
#include <string>
#include <string_view>

/// What the readers of several kinds of files do with texts.
namespace synthetic_dataset::world {

[[nodiscard]] inline bool startsWith(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

/// Without the blanks before and behind it.
[[nodiscard]] inline std::string trimmed(const std::string& text) {
  constexpr const char* kBlanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// With slashes for backslashes, which exporters on Windows write.
[[nodiscard]] inline std::string withSlashes(std::string uri) {
  std::replace(uri.begin(), uri.end(), '\\', '/');
  return uri;
}

}  // namespace synthetic_dataset::world
