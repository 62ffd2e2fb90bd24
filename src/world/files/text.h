#pragma once

#include <algorithm>
#include <string>
#include <string_view>

/// String helpers for the readers of several file formats.
namespace synthetic_dataset::world {

[[nodiscard]] inline bool startsWith(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

/// The text without leading and trailing blanks.
[[nodiscard]] inline std::string trimmed(const std::string& text) {
  constexpr const char* kBlanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// Replaces backslashes, which exporters on Windows write, by slashes.
[[nodiscard]] inline std::string withSlashes(std::string uri) {
  std::replace(uri.begin(), uri.end(), '\\', '/');
  return uri;
}

}  // namespace synthetic_dataset::world
