#include "programs/console/settings_source.h"

#include "config/settings_file.h"
#include "run/setup/package_index.h"

namespace synthetic_dataset::programs {

Value settingsOf(const CommandLine& command_line, const base::Remark& remark) {
  Value::Map settings = config::loadSettings(*command_line.config, run::rosPackageFinder(), remark);
  for (const auto& [name, text] : command_line.settings) {
    config::overlay(settings, config::settingOf(name, text));
  }
  return settings;
}

}  // namespace synthetic_dataset::programs
