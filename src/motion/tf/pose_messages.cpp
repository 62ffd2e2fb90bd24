#include "motion/tf/pose_messages.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nav_msgs/Odometry.h>

#include "motion/bag/checked_messages.h"

namespace synthetic_dataset::motion {
namespace {

using Message = BagMessage;
using Transform = geometry_msgs::TransformStamped;
using Transforms = std::vector<Transform>;

Transform transformOf(const std_msgs::Header& header, const std::string& child,
                      const geometry_msgs::Pose& pose) {
  Transform transform;
  transform.header = header;
  transform.child_frame_id = child;
  transform.transform.translation.x = pose.position.x;
  transform.transform.translation.y = pose.position.y;
  transform.transform.translation.z = pose.position.z;
  transform.transform.rotation = pose.orientation;
  return transform;
}

Transforms readOdometry(const Message& message, const std::string& frame) {
  const auto odometry = message.instantiate<nav_msgs::Odometry>();
  return {transformOf(odometry->header, frame.empty() ? odometry->child_frame_id : frame,
                      odometry->pose.pose)};
}

Transforms readPose(const Message& message, const std::string& frame) {
  const auto pose = message.instantiate<geometry_msgs::PoseStamped>();
  return {transformOf(pose->header, frame, pose->pose)};
}

/// The poses of several things without names, which are numbered in order: "person_0", "person_1",
/// ...
Transforms readPoses(const Message& message, const std::string& frame) {
  const auto poses = message.instantiate<geometry_msgs::PoseArray>();
  Transforms transforms;
  for (const geometry_msgs::Pose& pose : poses->poses) {
    const std::string name = frame + "_" + std::to_string(transforms.size());
    transforms.push_back(transformOf(poses->header, name, pose));
  }
  return transforms;
}

Transforms readPoseWithCovariance(const Message& message, const std::string& frame) {
  const auto pose = message.instantiate<geometry_msgs::PoseWithCovarianceStamped>();
  return {transformOf(pose->header, frame, pose->pose.pose)};
}

Transforms readTransform(const Message& message, const std::string& frame) {
  Transform transform = *message.instantiate<Transform>();
  if (!frame.empty()) transform.child_frame_id = frame;
  return {transform};
}

/// A model's frame has the model's name; a link "model::link" has the frame "model/link". Both are
/// in Gazebo's frame "world", and have no time stamps.
Transforms readStates(const Message& message, const std::string& /*frame*/) {
  const auto states = message.instantiate<RecordedStates>();
  std_msgs::Header header;
  header.frame_id = "world";
  Transforms transforms;
  const std::size_t count = std::min(states->names.size(), states->poses.size());
  for (std::size_t i = 0; i < count; ++i) {
    std::string name = states->names[i];
    for (std::size_t at = name.find("::"); at != std::string::npos; at = name.find("::", at)) {
      name.replace(at, 2, "/");
    }
    transforms.push_back(transformOf(header, name, states->poses[i]));
  }
  return transforms;
}

template <class Type>
std::string md5sumOf() {
  return ros::message_traits::MD5Sum<Type>::value();
}

}  // namespace

const std::vector<PoseMessage>& poseMessages() {
  using geometry_msgs::PoseArray;
  using geometry_msgs::PoseStamped;
  using geometry_msgs::PoseWithCovarianceStamped;
  static const std::vector<PoseMessage> kMessages{
      {"nav_msgs/Odometry", md5sumOf<nav_msgs::Odometry>(), true, true, readOdometry},
      {"geometry_msgs/PoseStamped", md5sumOf<PoseStamped>(), false, true, readPose},
      {"geometry_msgs/PoseArray", md5sumOf<PoseArray>(), false, false, readPoses},
      {"geometry_msgs/PoseWithCovarianceStamped", md5sumOf<PoseWithCovarianceStamped>(), false,
       true, readPoseWithCovariance},
      {"geometry_msgs/TransformStamped", md5sumOf<Transform>(), true, true, readTransform},
      {RecordedStates::kModelStates, md5sumOf<RecordedStates>(), true, false, readStates},
      {RecordedStates::kLinkStates, md5sumOf<RecordedStates>(), true, false, readStates},
  };
  return kMessages;
}

}  // namespace synthetic_dataset::motion
