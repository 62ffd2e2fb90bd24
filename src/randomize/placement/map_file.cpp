#include "randomize/placement/map_file.h"

#include <cstdint>
#include <filesystem>
#include <vector>

#include "base/yaml_value.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::randomize {
namespace {

/// Reads a number; if it is one, checks it against a rule.
template <class Rule>
double numberThat(Rule isRight, Parameters& root, const std::string& name,
                  const std::string& should) {
  const std::size_t errors_before = root.errors().size();
  const auto number = root.required<double>(name);
  if (root.errors().size() == errors_before && !isRight(number)) {
    root.addError(name, "found " + Value(number).text() + "; it should be " + should);
  }
  return number;
}

void readThresholds(Parameters& root, MapFile& map) {
  const auto isShare = [](double number) { return number >= 0.0 && number <= 1.0; };
  const std::size_t errors_before = root.errors().size();
  map.occupied_threshold = numberThat(isShare, root, "occupied_thresh", "0 to 1");
  map.free_threshold = numberThat(isShare, root, "free_thresh", "0 to 1");
  const bool both_right = root.errors().size() == errors_before;
  if (both_right && map.free_threshold >= map.occupied_threshold) {
    root.addError("free_thresh", "found " + Value(map.free_threshold).text() +
                                     "; it should be less than occupied_thresh, " +
                                     Value(map.occupied_threshold).text());
  }
}

void readOrigin(Parameters& root, MapFile& map) {
  const std::size_t errors_before = root.errors().size();
  const auto origin = root.required<std::vector<double>>("origin");
  if (root.errors().size() > errors_before) return;
  if (origin.size() != 3) {
    root.addError("origin", "found " + std::to_string(origin.size()) +
                                " numbers; it should be 3: [x, y, yaw] in metres and radians");
    return;
  }
  map.x = origin[0];
  map.y = origin[1];
  map.yaw = origin[2];
}

/// map_saver writes 0; people also write false.
bool readNegate(Parameters& root) {
  const std::size_t errors_before = root.errors().size();
  const auto negate = root.required<Value>("negate");
  if (negate == Value(true) || negate == Value(1)) return true;
  const bool is_right = negate == Value(false) || negate == Value(0);
  if (!is_right && root.errors().size() == errors_before) {
    root.addError("negate", "found " + negate.text() + "; it should be 0 or 1");
  }
  return false;
}

MapMode readMode(Parameters& root) {
  const auto mode = root.optional<std::string>("mode", "trinary");
  if (mode == "scale") return MapMode::kScale;
  if (mode == "raw") return MapMode::kRaw;
  if (mode != "trinary") {
    root.addError("mode", "found '" + mode + "'; it should be trinary, scale or raw");
  }
  return MapMode::kTrinary;
}

std::string readImage(Parameters& root, const std::string& file) {
  const std::size_t errors_before = root.errors().size();
  const auto image = root.required<std::string>("image");
  if (image.empty() && root.errors().size() == errors_before) {
    root.addError("image", "found an empty text; it should be the path of the map's picture");
  }
  return (std::filesystem::path(file).parent_path() / image).lexically_normal().string();
}

}  // namespace

MapFile readMapYaml(const std::string& file) {
  Parameters root(base::loadYamlFile(file));
  const auto isPositive = [](double number) { return number > 0.0; };
  MapFile map;
  map.image = readImage(root, file);
  map.resolution = numberThat(isPositive, root, "resolution", "above 0: the metres of a cell");
  readOrigin(root, map);
  map.negate = readNegate(root);
  readThresholds(root, map);
  map.mode = readMode(root);
  if (root.errors().empty()) return map;
  std::vector<std::string> named;
  for (const std::string& error : root.errors()) named.push_back(file + ": " + error);
  throw ErrorList(named);
}

}  // namespace synthetic_dataset::randomize
