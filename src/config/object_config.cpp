#include "config/object_config.h"

#include <map>
#include <set>

#include "config/checked_values.h"

namespace synthetic_dataset::config {
namespace {

/// `class` and `id` may be a text or a number. They are words of label files, a line an object.
std::string readLabel(const Parameters& group, const std::string& name) {
  const Value value = group.required<Value>(name);
  std::string text = value.text();
  if (value.is<Value::List>() || value.is<Value::Map>()) {
    group.addError(name, "found " + value.kind() + "; it should be a text or a number");
  } else if (text.empty() || text.find_first_of("\n\r") != std::string::npos) {
    group.addError(name, "found a text that is empty or has more than one line");
  }
  return text;
}

ObjectConfig readObject(const Parameters& root, const std::string& name) {
  const Parameters group = root.group(name);
  ObjectConfig object;
  object.name = name;
  object.class_name = readLabel(group, "class");
  object.id = readLabel(group, "id");
  object.frame = name + "/" + group.optional<std::string>("frame_id", "base_link");
  object.model = group.maybe<std::string>("model");
  if (object.model) object.model = pathOrUri(*object.model);
  object.keypoints_O = group.required<std::vector<Eigen::Vector3d>>("keypoints");
  object.bounding_shape_O = group.required<std::vector<Eigen::Vector3d>>("bounding_shape");
  if (isEmptyList(group, "bounding_shape")) {
    group.addError("bounding_shape", "found no points; it should circumscribe the object");
  }
  return object;
}

}  // namespace

std::vector<ObjectConfig> readObjects(const Parameters& root) {
  const auto names = root.required<std::vector<std::string>>("robot_list");
  if (isEmptyList(root, "robot_list")) {
    root.addError("robot_list", "found an empty list; it should name at least one object");
  }
  std::vector<ObjectConfig> objects;
  std::set<std::string> seen;
  std::map<std::string, std::string> ids;
  for (std::string name : names) {
    if (!name.empty() && name.front() == '/') name.erase(0, 1);
    if (name.empty() || !seen.insert(name).second) {
      root.addError("robot_list",
                    name.empty() ? "found an empty name" : "found '" + name + "' more than once");
      continue;
    }
    objects.push_back(readObject(root, name));
    const ObjectConfig& object = objects.back();
    const auto [same, added] = ids.emplace(object.id, name);
    if (!added && root.group(name).has("id")) {
      root.addError(name + "/id", "found " + object.id + ", which is also the id of '" +
                                      same->second + "'; each object should have its own");
    }
  }
  return objects;
}

}  // namespace synthetic_dataset::config
