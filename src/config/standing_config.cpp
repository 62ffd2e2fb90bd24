#include "config/readers.h"

#include <algorithm>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "config/checked_values.h"
#include "config/distribution_config.h"
#include "config/pose_config.h"
#include "synthetic_dataset/nearest_name.h"

/// Objects that stand still in the world and follow no frame.
namespace synthetic_dataset::config {
namespace {

const char* const kOrPosition =
    ", or {position: [x, y, z], rpy: [roll, pitch, yaw]}, or world: where the world has its model "
    "of this name";

Pose poseByAngles(Parameters group) {
  if (!group.has("position")) (void)group.required<Value>("position");
  const auto position = maybeVector(group, "position", kFarthest, "[x, y, z] [m]");
  const Eigen::Vector3d rpy = maybeAngles(group).value_or(Eigen::Vector3d::Zero());
  const Eigen::Quaterniond rotation = Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
                                      Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
                                      Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX());
  return makePose(position.value_or(Eigen::Vector3d::Zero()), rotation);
}

void refuseFrames(Parameters& group) {
  for (const char* name : {"frame", "frame_id", "link_frames", "count"}) {
    if (!group.has(name)) continue;
    group.addError(name,
                   "found together with pose; an object stands where pose says, or follows the "
                   "frames of a recording");
    group.ignore(name);
  }
}

}  // namespace

bool readStanding(Parameters& group, scene::ObjectOptions& object) {
  if (!group.has("pose")) return false;
  const auto given = group.required<Value>("pose");
  object.stands = true;
  object.frame = "standing: " + object.name;  // a name that no recording has
  refuseFrames(group);
  if (const auto* text = given.as<std::string>()) {
    if (*text != "world") {
      group.addError("pose", "found '" + *text + "'; it should be [x, y, z, qx, qy, qz, qw]" +
                                 std::string(kOrPosition));
    } else if (group.has("model")) {
      group.addError("pose",
                     "found world together with model; a model of its own stands where numbers "
                     "say: [x, y, z, qx, qy, qz, qw], or {position: [x, y, z], rpy: [roll, pitch, "
                     "yaw]}");
    }
  } else if (given.is<Value::Map>()) {
    object.X_GM = poseByAngles(group.group("pose"));
  } else {
    object.X_GM = readPose(group, "pose", kOrPosition);
  }
  return true;
}

void checkWorldObjects(Parameters& root) {
  static const std::vector<std::string> kKnown = {
      "bounding_shape", "class", "keypoint_names", "keypoints", "models", "parts", "skeleton"};
  const auto given = root.maybe<Value>("world_objects");
  if (!given) return;
  const std::string should = "; it should be a list such as [{class: car, models: \"car_*\"}]";
  const auto* entries = given->as<Value::List>();
  if (entries == nullptr || entries->empty()) {
    root.addError("world_objects",
                  "found " + (entries == nullptr ? given->kind() : "an empty list") + should);
    return;
  }
  for (std::size_t i = 0; i < entries->size(); ++i) {
    const std::string name = "world_objects/" + std::to_string(i);
    if (!(*entries)[i].is<Value::Map>()) {
      root.addError(name, "found " + (*entries)[i].kind() +
                              "; it should be a group like {class: car, models: \"car_*\"}");
      continue;
    }
    Parameters entry((*entries)[i], name);
    (void)readLabel(entry, "class");
    (void)readNames(entry, "models", "models of the world");
    for (const std::string& each : entry.names()) {
      if (std::find(kKnown.begin(), kKnown.end(), each) != kKnown.end()) continue;
      entry.addError(each, "unknown parameter" + didYouMean(each, kKnown));
    }
    for (const std::string& error : entry.errors()) {
      const std::size_t end = error.find(": ");
      root.addError(error.substr(0, end), error.substr(end + 2));
    }
  }
}

}  // namespace synthetic_dataset::config
