#pragma once

#include <functional>
#include <string>

#include "base/yaml_value.h"
#include "config/launch_substitution.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::config {

/// What the settings of a file come from, beside it.
struct SettingsSources {
  TextFinder package_folder;                     ///< where ROS packages are
  TextFinder environment = environmentVariable;  ///< may throw Error
  /// Gets each file that is included before it is read, and throws Error where it may not be.
  std::function<void(const std::string& file)> admit = [](const std::string&) {};
};

/// The settings of a YAML file as roslaunch would load them into the parameter server:
/// substitutions filled in, read as `<rosparam>` does, kept as the server keeps them (see
/// asParameters). The files that its setting `include` names, one or a list, lie below it: their
/// settings count where it has none of its own; of several, those of the later ones.
/// @param file  may be relative to the current folder
/// @param remark  as parseSettings() has it
/// @throws Error naming file and line; for a file that includes itself, too
[[nodiscard]] Value::Map loadSettings(const std::string& file, const SettingsSources& sources,
                                      const base::Remark& remark = {});

/// The same with the environment of this process, and any file included.
[[nodiscard]] Value::Map loadSettings(const std::string& file, const TextFinder& package_folder,
                                      const base::Remark& remark = {});

/// A file's tree as the parameter server would keep it: `yolo/main_list` is `main_list` in the
/// group `yolo`, empty groups vanish, and the global name `/robot_list` counts where there is no
/// other `robot_list`.
/// @param origin  for messages
/// @throws Error where a name is given twice, or as a group and as a value, or is global otherwise
[[nodiscard]] Value::Map asParameters(const Value& tree, const std::string& origin);

/// Puts settings over others: groups are merged, all else is replaced, distributions too.
void overlay(Value::Map& settings, const Value::Map& over);

/// The same of what overrides a file's settings from outside, as on a command line: an
/// `output_folder` moves the writers' folders, too, below itself.
void overrideBy(const Value::Map& over, Value::Map& settings);

/// A group of settings; null where there is none of this name.
[[nodiscard]] Value::Map* groupIn(Value::Map& settings, const std::string& name);
[[nodiscard]] const Value::Map* groupIn(const Value::Map& settings, const std::string& name);

/// The settings that `name:=text` on the command line stands for.
/// @param name  a parameter's path, such as `yolo/main_list`
/// @param text  YAML
/// @throws Error naming the setting
[[nodiscard]] Value::Map settingOf(const std::string& name, const std::string& text);

}  // namespace synthetic_dataset::config
