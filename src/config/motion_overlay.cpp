#include "config/motion_overlay.h"

#include <vector>

#include "config/settings_file.h"

namespace synthetic_dataset::config {
namespace {

using Names = std::vector<std::string>;

bool hasKey(const Value::Map& map, const std::string& name) { return map.count(name) != 0; }

/// Removes alternatives to the entry's own settings from those of the run.
void dropAlternatives(Value::Map& below, const Value::Map& own, const Names& alternatives) {
  bool is_there = false;
  for (const std::string& name : alternatives) is_there = is_there || hasKey(own, name);
  for (const std::string& name : alternatives) {
    if (is_there && !hasKey(own, name)) below.erase(name);
  }
}

void dropCameraAlternatives(Value::Map& below, const Value::Map& own) {
  dropAlternatives(below, own, {"info_file", "info_topic", "sensor"});
  dropAlternatives(below, own, {"pose", "mounted_on", "sample"});
}

void makeWayForCameras(Value::Map& settings, const Value::Map& own) {
  dropAlternatives(settings, own, {"camera", "cameras"});
  if (hasKey(own, "cameras")) settings.erase("camera_frame_id");
  if (hasKey(own, "camera") || hasKey(own, "camera_frame_id")) settings.erase("cameras");
  Value::Map* camera = groupIn(settings, "camera");
  const Value::Map* own_camera = groupIn(own, "camera");
  if (camera != nullptr && own_camera != nullptr) dropCameraAlternatives(*camera, *own_camera);
  Value::Map* cameras = groupIn(settings, "cameras");
  const Value::Map* own_cameras = groupIn(own, "cameras");
  if (cameras == nullptr || own_cameras == nullptr) return;
  for (auto& [name, below] : *cameras) {
    const Value::Map* over = groupIn(*own_cameras, name);
    if (over != nullptr && below.is<Value::Map>())
      dropCameraAlternatives(*below.as<Value::Map>(), *over);
  }
}

/// Converts `world: FILE` and `world_file` to `world: {file: FILE}`.
void spellOutWorld(Value::Map& settings) {
  const auto world = settings.find("world");
  if (world != settings.end() && world->second.is<std::string>()) {
    world->second = Value::Map{{"file", world->second}};
  }
  const auto file = settings.find("world_file");
  if (file == settings.end()) return;
  const Value name = file->second;
  settings.erase(file);
  Value& group = settings.emplace("world", Value::Map{}).first->second;
  if (group.is<Value::Map>()) (*group.as<Value::Map>())["file"] = name;
}

/// Removes the run's placement settings if the entry has another mode, which has other settings.
void makeWayForPlacement(Value::Map& settings, const Value::Map& own) {
  Value::Map* below = groupIn(settings, "placement");
  const Value::Map* over = groupIn(own, "placement");
  if (below == nullptr || over == nullptr) return;
  dropAlternatives(*below, *over, {"map", "map_topic", "received_map"});
  if (hasKey(*over, "mode")) settings.erase("placement");
}

}  // namespace

const std::set<std::string>& settingsOfMotions() {
  static const std::set<std::string> kNames = {
      "bag_file",     "camera",         "camera_frame_id", "cameras",   "duration",    "lidars",
      "max_tf_gap",   "motion",         "physics",         "placement", "pose_topics", "randomize",
      "scenes",       "simulated_rate", "start_offset",    "stretch",   "tf_topics",   "twin",
      "when_unknown", "world",          "world_file"};
  return kNames;
}

const std::set<std::string>& settingsOfMovedObjects() {
  static const std::set<std::string> kNames = {"frame", "frame_id", "link_frames", "safety_radius",
                                               "when_unknown"};
  return kNames;
}

void overlayMotion(Value::Map& settings, const Value::Map& own,
                   const std::set<std::string>& objects) {
  Value::Map over = own;
  spellOutWorld(settings);
  spellOutWorld(over);
  makeWayForCameras(settings, over);
  makeWayForPlacement(settings, over);
  for (const std::string& name : objects) {
    Value::Map* object = groupIn(settings, name);
    const Value::Map* own_object = groupIn(own, name);
    if (object == nullptr || own_object == nullptr) continue;
    dropAlternatives(*object, *own_object, {"frame", "frame_id"});
    if (hasKey(*own_object, "link_frames")) object->erase("link_frames");
  }
  overlay(settings, over);
}

}  // namespace synthetic_dataset::config
