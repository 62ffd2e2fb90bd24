#pragma once

#include <string>
#include <vector>

#include <geometry_msgs/Pose.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/serialization.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>

/// Messages as stored in bags, whose list lengths are checked against the available bytes before
/// roscpp allocates as much as they claim. Wrong lengths throw Error.
namespace synthetic_dataset::motion {

template <class Message>
struct Checked {
  Message message;
};

using RecordedTransforms = Checked<tf2_msgs::TFMessage>;
using RecordedCalibration = Checked<sensor_msgs::CameraInfo>;
using RecordedGrid = Checked<nav_msgs::OccupancyGrid>;
using RecordedJoints = Checked<sensor_msgs::JointState>;
using RecordedImage = Checked<sensor_msgs::Image>;
using RecordedImageFile = Checked<sensor_msgs::CompressedImage>;
using RecordedCloud = Checked<sensor_msgs::PointCloud2>;

/// The common content of gazebo_msgs/ModelStates and gazebo_msgs/LinkStates, without the
/// velocities.
struct RecordedStates {
  std::vector<std::string> names;
  std::vector<geometry_msgs::Pose> poses;  ///< in Gazebo's world

  static constexpr const char* kModelStates = "gazebo_msgs/ModelStates";
  static constexpr const char* kLinkStates = "gazebo_msgs/LinkStates";
};

/// Checks a message's lists.
/// @param stream  at the start of the message
/// @param kind  selects the message's type
void checkLists(ros::serialization::IStream stream, const RecordedTransforms& kind);
void checkLists(ros::serialization::IStream stream, const RecordedCalibration& kind);
void checkLists(ros::serialization::IStream stream, const RecordedGrid& kind);
void checkLists(ros::serialization::IStream stream, const RecordedJoints& kind);
void checkLists(ros::serialization::IStream stream, const RecordedImage& kind);
void checkLists(ros::serialization::IStream stream, const RecordedImageFile& kind);
void checkLists(ros::serialization::IStream stream, const RecordedCloud& kind);
void checkLists(ros::serialization::IStream stream, const RecordedStates& kind);

}  // namespace synthetic_dataset::motion

namespace ros {
namespace message_traits {

template <class Message>
struct MD5Sum<synthetic_dataset::motion::Checked<Message>> : MD5Sum<Message> {};

/// Both types have the same fields: string[] name, Pose[] pose, Twist[] twist.
template <>
struct MD5Sum<synthetic_dataset::motion::RecordedStates> {
  static const char* value() { return "48c080191eb15c41858319b4d8a609c2"; }
  static const char* value(const synthetic_dataset::motion::RecordedStates& /*states*/) {
    return value();
  }
};

}  // namespace message_traits

namespace serialization {

template <class Message>
struct Serializer<synthetic_dataset::motion::Checked<Message>> {
  static void read(IStream& stream, synthetic_dataset::motion::Checked<Message>& into) {
    synthetic_dataset::motion::checkLists(stream, into);
    stream.next(into.message);
  }
};

template <>
struct Serializer<synthetic_dataset::motion::RecordedStates> {
  static void read(IStream& stream, synthetic_dataset::motion::RecordedStates& into) {
    synthetic_dataset::motion::checkLists(stream, into);
    stream.next(into.names);
    stream.next(into.poses);
  }
};

}  // namespace serialization
}  // namespace ros
