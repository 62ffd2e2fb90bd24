#include "base/ros_messages/scene_messages.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include <ros/time.h>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::ros_messages {
namespace {

using visualization_msgs::Marker;

ros::Time toRosTime(Stamp stamp) {
  constexpr Stamp kEnd = std::chrono::seconds(std::numeric_limits<std::uint32_t>::max());
  if (stamp <= Stamp{0} || stamp >= kEnd) {
    throw Error("found the time " + std::to_string(stamp.count()) +
                " ns; ROS has times after 0 and before 2^32 s");
  }
  return ros::Time().fromNSec(static_cast<std::uint64_t>(stamp.count()));
}

geometry_msgs::Quaternion toQuaternion(const Pose& X_AB) {
  const Eigen::Quaterniond q(X_AB.linear());
  geometry_msgs::Quaternion result;
  result.x = q.x();
  result.y = q.y();
  result.z = q.z();
  result.w = q.w();
  return result;
}

/// Converts to any type of geometry_msgs with x, y and z.
template <class Message>
Message toXyz(const Eigen::Vector3d& p) {
  Message result;
  result.x = p.x();
  result.y = p.y();
  result.z = p.z();
  return result;
}

/// D and its model: http://docs.ros.org/en/noetic/api/sensor_msgs/html/msg/CameraInfo.html
void addDistortion(const Distortion& distortion, sensor_msgs::CameraInfo& info) {
  Distortion named = distortion;
  if (named.model == DistortionModel::kNone) named.model = DistortionModel::kPlumbBob;
  info.distortion_model = distortionModelName(named.model);
  info.D = coefficientsOf(named);
}

/// Adds a transform unless the frame is its own parent, which tf2 refuses.
void addTransform(const std_msgs::Header& header, const std::string& child, const Pose& X_GB,
                  tf2_msgs::TFMessage& message) {
  if (child == header.frame_id) return;
  message.transforms.push_back(transform(header, child, X_GB));
}

Marker boxMarker(const std_msgs::Header& header, const SceneObject& object) {
  Marker box;
  box.header = header;
  box.ns = object.class_name;
  box.id = object.instance;
  box.type = Marker::CUBE;
  box.pose.position = toXyz<geometry_msgs::Point>(*object.X_GO * object.cuboid_O.centre());
  box.pose.orientation = toQuaternion(*object.X_GO);
  box.scale = toXyz<geometry_msgs::Vector3>(object.cuboid_O.size());
  box.color = classColour(object.class_id, 0.35F);
  return box;
}

/// The object's name, above its box.
Marker nameMarker(const std_msgs::Header& header, const SceneObject& object) {
  const double letter_height = 0.2 * object.cuboid_O.size().norm();  // [m]
  Eigen::Vector3d p_GN = *object.X_GO * object.cuboid_O.centre();
  for (const Eigen::Vector3d& corner_O : object.cuboid_O.corners()) {
    p_GN.z() = std::max(p_GN.z(), (*object.X_GO * corner_O).z() + letter_height);
  }
  Marker name;
  name.header = header;
  name.ns = object.class_name + " names";
  name.id = object.instance;
  name.type = Marker::TEXT_VIEW_FACING;
  name.pose.position = toXyz<geometry_msgs::Point>(p_GN);
  name.pose.orientation.w = 1.0;
  name.scale.z = letter_height;
  name.color = classColour(object.class_id, 1.0F);
  name.text = object.name;
  return name;
}

/// tf2 does not accept a leading slash.
std::string withoutSlash(const std::string& frame) {
  const std::size_t begin = frame.find_first_not_of('/');
  return begin == std::string::npos ? "" : frame.substr(begin);
}

}  // namespace

bool isTopicLetter(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_' || letter == '/';
}

std::vector<std::string> topicNames(const std::vector<std::string>& names) {
  std::vector<std::string> topics;
  for (std::string name : names) {
    std::replace_if(
        name.begin(), name.end(), [](char letter) { return !isTopicLetter(letter); }, '_');
    std::string unique = name;
    for (int count = 2; std::count(topics.begin(), topics.end(), unique) != 0; ++count) {
      unique = name + "_" + std::to_string(count);
    }
    topics.push_back(unique);
  }
  return topics;
}

SceneFrames::SceneFrames(const std::string& global_frame, const std::string& prefix)
    : global_frame_(withoutSlash(global_frame)), prefix_(withoutSlash(prefix)) {}

std::string SceneFrames::of(const std::string& name) const { return prefix_ + withoutSlash(name); }

std_msgs::ColorRGBA classColour(int class_id, float opacity) {
  constexpr double kGoldenRatio = 0.6180339887498949;
  const double hue = std::fmod(class_id * kGoldenRatio, 1.0);
  // HSV to RGB with S = V = 1: V - max(0, min(k, 4 - k, 1)), k = (n + 6 hue) mod 6, n = 5, 3, 1.
  const auto channel = [&](double n) {
    const double k = std::fmod(n + 6.0 * hue, 6.0);
    return static_cast<float>(1.0 - std::max(0.0, std::min({k, 4.0 - k, 1.0})));
  };
  std_msgs::ColorRGBA colour;
  colour.r = channel(5.0);
  colour.g = channel(3.0);
  colour.b = channel(1.0);
  colour.a = opacity;
  return colour;
}

std_msgs::Header headerOf(Stamp stamp, const std::string& frame) {
  std_msgs::Header result;
  result.stamp = toRosTime(stamp);
  result.frame_id = frame;
  return result;
}

sensor_msgs::CameraInfo cameraInfo(const std_msgs::Header& header, const CameraModel& camera) {
  sensor_msgs::CameraInfo info;
  info.header = header;
  info.width = static_cast<std::uint32_t>(camera.width());
  info.height = static_cast<std::uint32_t>(camera.height());
  addDistortion(camera.distortion(), info);
  const Intrinsics& k = camera.intrinsics();
  info.K = {k.fx, 0.0, k.cx, 0.0, k.fy, k.cy, 0.0, 0.0, 1.0};
  info.R = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  info.P = {k.fx, 0.0, k.cx, 0.0, 0.0, k.fy, k.cy, 0.0, 0.0, 0.0, 1.0, 0.0};
  return info;
}

geometry_msgs::TransformStamped transform(const std_msgs::Header& header, const std::string& child,
                                          const Pose& X_GB) {
  geometry_msgs::TransformStamped result;
  result.header = header;
  result.child_frame_id = child;
  result.transform.translation = toXyz<geometry_msgs::Vector3>(X_GB.translation());
  result.transform.rotation = toQuaternion(X_GB);
  return result;
}

tf2_msgs::TFMessage transforms(const Scene& scene, const CameraFrame& camera,
                               const SceneFrames& frames) {
  tf2_msgs::TFMessage result;
  const std_msgs::Header global = headerOf(scene.stamp, frames.globalFrame());
  if (camera.has_pose) addTransform(global, frames.of(camera.name), scene.X_GC, result);
  if (camera.has_objects) {
    for (const SceneObject& object : scene.objects) {
      if (object.X_GO) addTransform(global, frames.of(object.name), *object.X_GO, result);
    }
  }
  return result;
}

visualization_msgs::MarkerArray objectMarkers(const Scene& scene, const SceneFrames& frames) {
  const std_msgs::Header header = headerOf(scene.stamp, frames.globalFrame());
  visualization_msgs::MarkerArray result;
  // Objects that have left the picture are not named again, so all earlier markers are deleted.
  Marker clear;
  clear.header = header;
  clear.action = Marker::DELETEALL;
  clear.pose.orientation.w = 1.0;
  result.markers.push_back(clear);
  for (const SceneObject& object : scene.objects) {
    if (!object.labelled()) continue;
    result.markers.push_back(boxMarker(header, object));
    result.markers.push_back(nameMarker(header, object));
  }
  return result;
}

}  // namespace synthetic_dataset::ros_messages
