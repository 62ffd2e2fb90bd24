#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/yaml_value.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// The parsed arguments of `generate`.
struct CommandLine {
  bool wants_help = false;
  bool wants_check = false;        ///< examines the run without making it
  bool wants_settings = false;     ///< prints all settings
  bool as_json = false;            ///< prints settings, or a run's progress and result, as JSON
  std::optional<std::string> out;  ///< the folder for the pictures of a check
  /// The settings file; without one, the settings are on the ROS parameter server.
  std::optional<std::string> config;
  /// `name:=value` in order, values as YAML. Only with `config`: otherwise these are ROS
  /// remappings.
  std::vector<std::pair<std::string, std::string>> settings;
};

/// @param arguments  without the program's name
/// @throws Error for unknown or invalid arguments
[[nodiscard]] CommandLine parseCommandLine(const std::vector<std::string>& arguments);

/// The same for `check`, whose settings file is named without an option.
[[nodiscard]] CommandLine parseCheckLine(const std::vector<std::string>& arguments);

/// Where the pictures of a check go: to --out, else beside the settings file.
[[nodiscard]] std::string picturesFolder(const CommandLine& line);

/// The output of `generate --help`.
[[nodiscard]] std::string usage();

/// The output of `check --help`.
[[nodiscard]] std::string checkUsage();

/// Does a tool's work, which returns the exit code. Prints what it throws to the standard error,
/// "NAME: message" for each error.
/// @return what the work returns; 1 when it throws
[[nodiscard]] int reportingErrors(const std::string& name, const std::function<int()>& work);

/// The settings of the file that a command line names, overridden by those on the command line.
/// Neither a ROS master nor ROS's log folder is needed.
/// @param remark  as for base::parseSettings()
/// @throws Error naming file and line, or the setting
[[nodiscard]] Value settingsOf(const CommandLine& command_line, const base::Remark& remark);

}  // namespace synthetic_dataset::programs
