#include "programs/drawing/lidar_rays.h"

#include <utility>

#include "base/yaml_value.h"
#include "config/readers.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::programs {
namespace {

/// Builds a group from settings that are named by their paths in it.
Value groupOf(const std::map<std::string, Value>& settings) {
  Value::Map group;
  std::map<std::string, std::map<std::string, Value>> inner;
  for (const auto& [path, value] : settings) {
    const std::size_t slash = path.find('/');
    if (slash == std::string::npos) {
      group[path] = value;
    } else {
      inner[path.substr(0, slash)][path.substr(slash + 1)] = value;
    }
  }
  for (const auto& [name, each] : inner) group[name] = groupOf(each);
  return group;
}

}  // namespace

std::map<std::string, std::int64_t> raysOfLidars(const output::RunDescription& run) {
  std::map<std::string, Value> settings;
  for (const auto& [name, setting] : run.settings) {
    if (name.rfind("lidars/", 0) != 0) continue;
    settings[name] = base::parseYaml(setting.value, "setting '" + name + "'");
  }
  std::map<std::string, std::int64_t> rays;
  for (const auto& lidar : config::readLidars(Parameters(groupOf(settings)), {})) {
    if (lidar.sensor) continue;
    rays[lidar.name] =
        static_cast<std::int64_t>(lidar.model.elevations.size()) * lidar::columnsOf(lidar.model);
  }
  return rays;
}

}  // namespace synthetic_dataset::programs
