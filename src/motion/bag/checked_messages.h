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

/// Messages as bags hold them, whose lists are held against the bytes that there are before roscpp
/// makes room for as much as they claim. What is wrong throws Error.
namespace synthetic_dataset::motion {

struct RecordedTransforms {
  tf2_msgs::TFMessage message;
};

struct RecordedCalibration {
  sensor_msgs::CameraInfo message;
};

struct RecordedGrid {
  nav_msgs::OccupancyGrid message;
};

struct RecordedJoints {
  sensor_msgs::JointState message;
};

struct RecordedImage {
  sensor_msgs::Image message;
};

struct RecordedImageFile {
  sensor_msgs::CompressedImage message;
};

struct RecordedCloud {
  sensor_msgs::PointCloud2 message;
};

/// What gazebo_msgs/ModelStates and gazebo_msgs/LinkStates hold alike, without their velocities.
struct RecordedStates {
  std::vector<std::string> names;
  std::vector<geometry_msgs::Pose> poses;  ///< in Gazebo's world

  static constexpr const char* kModelStates = "gazebo_msgs/ModelStates";
  static constexpr const char* kLinkStates = "gazebo_msgs/LinkStates";
};

/// @param stream  at the message's beginning
void checkTransforms(ros::serialization::IStream stream);
void checkCalibration(ros::serialization::IStream stream);
void checkGrid(ros::serialization::IStream stream);
void checkJoints(ros::serialization::IStream stream);
void checkImage(ros::serialization::IStream stream);
void checkImageFile(ros::serialization::IStream stream);
void checkCloud(ros::serialization::IStream stream);
void checkStates(ros::serialization::IStream stream);

}  // namespace synthetic_dataset::motion

namespace ros {
namespace message_traits {

template <>
struct MD5Sum<synthetic_dataset::motion::RecordedTransforms> : MD5Sum<tf2_msgs::TFMessage> {};

template <>
struct MD5Sum<synthetic_dataset::motion::RecordedCalibration> : MD5Sum<sensor_msgs::CameraInfo> {};

template <>
struct MD5Sum<synthetic_dataset::motion::RecordedGrid> : MD5Sum<nav_msgs::OccupancyGrid> {};

template <>
struct MD5Sum<synthetic_dataset::motion::RecordedJoints> : MD5Sum<sensor_msgs::JointState> {};

template <>
struct MD5Sum<synthetic_dataset::motion::RecordedImage> : MD5Sum<sensor_msgs::Image> {};

template <>
struct MD5Sum<synthetic_dataset::motion::RecordedImageFile> : MD5Sum<sensor_msgs::CompressedImage> {
};

template <>
struct MD5Sum<synthetic_dataset::motion::RecordedCloud> : MD5Sum<sensor_msgs::PointCloud2> {};

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

template <>
struct Serializer<synthetic_dataset::motion::RecordedTransforms> {
  static void read(IStream& stream, synthetic_dataset::motion::RecordedTransforms& into) {
    synthetic_dataset::motion::checkTransforms(stream);
    stream.next(into.message);
  }
};

template <>
struct Serializer<synthetic_dataset::motion::RecordedCalibration> {
  static void read(IStream& stream, synthetic_dataset::motion::RecordedCalibration& into) {
    synthetic_dataset::motion::checkCalibration(stream);
    stream.next(into.message);
  }
};

template <>
struct Serializer<synthetic_dataset::motion::RecordedGrid> {
  static void read(IStream& stream, synthetic_dataset::motion::RecordedGrid& into) {
    synthetic_dataset::motion::checkGrid(stream);
    stream.next(into.message);
  }
};

template <>
struct Serializer<synthetic_dataset::motion::RecordedJoints> {
  static void read(IStream& stream, synthetic_dataset::motion::RecordedJoints& into) {
    synthetic_dataset::motion::checkJoints(stream);
    stream.next(into.message);
  }
};

template <>
struct Serializer<synthetic_dataset::motion::RecordedImage> {
  static void read(IStream& stream, synthetic_dataset::motion::RecordedImage& into) {
    synthetic_dataset::motion::checkImage(stream);
    stream.next(into.message);
  }
};

template <>
struct Serializer<synthetic_dataset::motion::RecordedImageFile> {
  static void read(IStream& stream, synthetic_dataset::motion::RecordedImageFile& into) {
    synthetic_dataset::motion::checkImageFile(stream);
    stream.next(into.message);
  }
};

template <>
struct Serializer<synthetic_dataset::motion::RecordedCloud> {
  static void read(IStream& stream, synthetic_dataset::motion::RecordedCloud& into) {
    synthetic_dataset::motion::checkCloud(stream);
    stream.next(into.message);
  }
};

template <>
struct Serializer<synthetic_dataset::motion::RecordedStates> {
  static void read(IStream& stream, synthetic_dataset::motion::RecordedStates& into) {
    synthetic_dataset::motion::checkStates(stream);
    stream.next(into.names);
    stream.next(into.poses);
  }
};

}  // namespace serialization
}  // namespace ros
