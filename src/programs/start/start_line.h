#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace synthetic_dataset::programs {

/// The parsed arguments of `start`.
struct StartLine {
  bool wants_help = false;
  std::vector<std::string> bag_files;
  std::optional<std::string> world;
  std::vector<std::pair<std::string, std::string>> models;  ///< object's name and its model's file
  std::optional<std::string> camera_info;
  std::optional<std::vector<std::string>> formats;
  std::optional<std::string> output;  ///< the file to write; none: the standard output
};

/// @param arguments  without the program's name
/// @throws Error for unknown or invalid arguments
[[nodiscard]] StartLine parseStartLine(const std::vector<std::string>& arguments);

/// The output of `start --help`.
[[nodiscard]] std::string startUsage();

/// Splits a text at commas and blanks.
[[nodiscard]] std::vector<std::string> wordsIn(const std::string& text);

}  // namespace synthetic_dataset::programs
