#include <algorithm>

#include "base/yaml_value.h"
#include "scene/calibration/calibration_format.h"
#include "scene/calibration/calibration_names.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::scene {
namespace {

constexpr int kDeepestGroup = 4;

/// Whether a map describes a camera: it has any of a calibration's entries. Groups with one-letter
/// names such as `d` do not count, as they may mean something else.
bool isOfACamera(const Value::Map& map) {
  return std::any_of(map.begin(), map.end(), [](const Value::Map::value_type& entry) {
    const std::string name = plainName(entry.first);
    const bool is_letter = name.size() == 1;
    return rosNames().count(name) != 0 && !(is_letter && entry.second.is<Value::Map>());
  });
}

/// Collects the groups of a map, and those nested in them, that describe a camera: parameter files
/// have them inside other groups.
void collect(const Value::Map& map, const std::string& name, int depth,
             std::vector<ListedCamera>& cameras) {
  if (isOfACamera(map)) {
    cameras.push_back({name, map});
    return;
  }
  if (depth == kDeepestGroup) return;
  for (const auto& [key, value] : map) {
    const auto* group = value.as<Value::Map>();
    if (group != nullptr) {
      collect(*group, name.empty() ? key : name + "/" + key, depth + 1, cameras);
    }
  }
}

bool recognisesAnything(const std::string& /*text*/) { return true; }

std::vector<ListedCamera> readRosCalibration(const std::string& text, const std::string& file) {
  const Value root = base::parseYaml(text, file);
  const auto* map = root.as<Value::Map>();
  std::vector<ListedCamera> cameras;
  if (map != nullptr) collect(*map, "", 0, cameras);
  if (!cameras.empty()) return cameras;
  throw Error(file +
              ": it is not a known kind of calibration; it should be a camera_info YAML file, a "
              "printed CameraInfo, camera_calibration's ost.txt, a Kalibr camchain or OpenCV's "
              "FileStorage, with a camera_matrix");
}

}  // namespace

const CalibrationFormat kRosFormat = {recognisesAnything, readRosCalibration};

}  // namespace synthetic_dataset::scene
