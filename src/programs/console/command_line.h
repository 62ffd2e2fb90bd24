#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/yaml_value.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// What the arguments of `generate` ask for.
struct CommandLine {
  bool wants_help = false;
  bool wants_check = false;        ///< to look at the run before it is made
  bool wants_settings = false;     ///< to know all settings
  bool as_json = false;            ///< these as a JSON schema, or the run's end as a line of JSON
  std::optional<std::string> out;  ///< the folder for the pictures of that
  /// The settings file; without one, the settings are on the ROS parameter server.
  std::optional<std::string> config;
  /// `name:=value` in order, values as YAML. Only with `config`: else they are for ROS.
  std::vector<std::pair<std::string, std::string>> settings;
};

/// @param arguments  without the program's name
/// @throws Error for what is not known
[[nodiscard]] CommandLine parseCommandLine(const std::vector<std::string>& arguments);

/// The same of `check`, which names the file without an option.
[[nodiscard]] CommandLine parseCheckLine(const std::vector<std::string>& arguments);

/// Where the pictures of a check go: to --out, else beside the settings file.
[[nodiscard]] std::string picturesFolder(const CommandLine& line);

/// What `generate --help` prints.
[[nodiscard]] std::string usage();

/// What `check --help` prints.
[[nodiscard]] std::string checkUsage();

/// Does a tool's work, whose result is its exit code. What it throws is printed to the standard
/// error, "NAME: message" for each of its errors.
/// @return what the work returns; 1 when it throws
[[nodiscard]] int reportingErrors(const std::string& name, const std::function<int()>& work);

/// The settings of the file that a command line names, and over them its own. Neither a ROS master
/// nor ROS's log folder is needed.
/// @param remark  as base::parseSettings() has it
/// @throws Error naming file and line, or the setting
[[nodiscard]] Value settingsOf(const CommandLine& command_line, const base::Remark& remark);

}  // namespace synthetic_dataset::programs
