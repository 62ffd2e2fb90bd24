#pragma once

#include <functional>
#include <string>

#include "base/yaml_value.h"
#include "config/launch_substitution.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::config {

/// What the settings of a file depend on besides the file.
struct SettingsSources {
  TextFinder package_folder;                     ///< finds ROS packages
  TextFinder environment = environmentVariable;  ///< may throw Error
  /// Called with each included file before it is read; throws Error if it may not be included.
  std::function<void(const std::string& file)> admit = [](const std::string&) {};
};

/// Loads the settings of a YAML file as roslaunch would load them into the parameter server:
/// substitutions are replaced, the text is read as by `<rosparam>`, and the tree is stored as in
/// the server (see asParameters). The setting `include` names one file or a list of files whose
/// settings apply unless this file has its own; later files override earlier ones.
/// @param file  may be relative to the current folder
/// @param remark  as in parseSettings()
/// @throws Error naming file and line; also for a file that includes itself
[[nodiscard]] Value::Map loadSettings(const std::string& file, const SettingsSources& sources,
                                      const base::Remark& remark = {});

/// The same with the environment of this process, and with any file allowed in `include`.
[[nodiscard]] Value::Map loadSettings(const std::string& file, const TextFinder& package_folder,
                                      const base::Remark& remark = {});

/// A file's tree as the parameter server would store it: `yolo/main_list` is `main_list` in the
/// group `yolo`, empty groups vanish, and the global name `/robot_list` is used if there is no
/// other `robot_list`.
/// @param origin  for messages
/// @throws Error if a name is given twice, or as a group and as a value, or another name is global
[[nodiscard]] Value::Map asParameters(const Value& tree, const std::string& origin);

/// Overlays settings with others: groups are merged, all else is replaced, including distributions.
void overlay(Value::Map& settings, const Value::Map& over);

/// The same for overrides from outside the file, as on a command line: an `output_folder` also
/// moves the writers' folders below itself.
void overrideBy(const Value::Map& over, Value::Map& settings);

/// A group of settings; nullptr if there is none of this name.
[[nodiscard]] Value::Map* groupIn(Value::Map& settings, const std::string& name);
[[nodiscard]] const Value::Map* groupIn(const Value::Map& settings, const std::string& name);

/// The settings given by `name:=text` on the command line.
/// @param name  a parameter's path, such as `yolo/main_list`
/// @param text  YAML
/// @throws Error naming the setting
[[nodiscard]] Value::Map settingOf(const std::string& name, const std::string& text);

}  // namespace synthetic_dataset::config
