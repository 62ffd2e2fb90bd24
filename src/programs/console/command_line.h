#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace synthetic_dataset::programs {

/// What the arguments of `generate` ask for.
struct CommandLine {
  bool wants_help = false;
  /// The settings file; without one, the settings are on the ROS parameter server.
  std::optional<std::string> config;
  /// `name:=value` in order, values as YAML. Only with `config`: else they are for ROS.
  std::vector<std::pair<std::string, std::string>> settings;
};

/// @param arguments  without the program's name
/// @throws Error for what is not known
[[nodiscard]] CommandLine parseCommandLine(const std::vector<std::string>& arguments);

/// What `generate --help` prints.
[[nodiscard]] std::string usage();

}  // namespace synthetic_dataset::programs
