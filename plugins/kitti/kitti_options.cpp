#include "plugins/kitti/kitti_options.h"

#include <algorithm>

#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset {
namespace {

/// Reads the parameter `class_names`: class to KITTI's type. Types end at the first space.
std::map<std::string, std::string> typesOf(Parameters& parameters,
                                           const std::vector<ClassInfo>& classes) {
  std::map<std::string, std::string> types;
  std::vector<std::string> names;
  for (const ClassInfo& each : classes) {
    names.push_back(each.name);
    std::string type = each.name;
    std::replace_if(
        type.begin(), type.end(), [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }, '_');
    const bool is_taken = std::any_of(types.begin(), types.end(),
                                      [&](const auto& other) { return other.second == type; });
    if (is_taken && !parameters.group("class_names").has(each.name)) {
      parameters.group("class_names")
          .addError(each.name, "the class is called '" + type +
                                   "' like another where spaces are not allowed; give it a name");
    }
    types[each.name] = type;
  }
  Parameters group = parameters.group("class_names");
  for (const std::string& name : group.names()) {
    const auto type = group.required<std::string>(name);
    if (types.count(name) == 0) {
      group.addError(name, "no object has this class" + didYouMean(name, names));
    } else if (type == kDontCare) {
      group.addError(name, "found 'DontCare', which is what KITTI calls regions without labels");
    } else if (type.empty() || type.find_first_of(" \t\n\v\f\r") != std::string::npos) {
      group.addError(name, "found '" + type + "'; it should be a word without spaces");
    } else {
      types[name] = type;
    }
  }
  return types;
}

/// Reads `velodyne`: `none`, `depth` or a lidar's name.
void readVelodyne(Parameters& parameters, const DatasetInfo& dataset, KittiOptions& options) {
  if (dataset.lidars.empty()) {
    options.velodyne = parameters.optionalChoice("velodyne", {"none", "depth"}, "none") == "depth";
    return;
  }
  const auto velodyne = parameters.optional<std::string>("velodyne", "none");
  options.velodyne = velodyne == "depth";
  if (velodyne == "none" || velodyne == "depth") return;
  options.lidar = dataset.lidarIndex(parameters, "velodyne", velodyne);
  if (options.lidar) options.lidar_frame = dataset.lidars[*options.lidar].frame;
  options.global_frame = dataset.global_frame;
  options.positions = readCloudPositions(parameters);
  options.min_points = readMinPoints(parameters);
}

}  // namespace

KittiOptions readKittiOptions(Parameters& parameters, const DatasetInfo& dataset) {
  KittiOptions options;
  options.types = typesOf(parameters, dataset.classes);
  options.box = readBoxChoice(parameters);
  options.dont_care = parameters.optional("dont_care", options.dont_care);
  readVelodyne(parameters, dataset, options);
  return options;
}

}  // namespace synthetic_dataset
