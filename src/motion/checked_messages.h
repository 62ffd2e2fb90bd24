#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/serialization.h>
#include <sensor_msgs/CameraInfo.h>
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

/// @param stream  at the message's beginning
void checkTransforms(ros::serialization::IStream stream);
void checkCalibration(ros::serialization::IStream stream);
void checkGrid(ros::serialization::IStream stream);

}  // namespace synthetic_dataset::motion

namespace ros {
namespace message_traits {

template <>
struct MD5Sum<synthetic_dataset::motion::RecordedTransforms> : MD5Sum<tf2_msgs::TFMessage> {};

template <>
struct MD5Sum<synthetic_dataset::motion::RecordedCalibration> : MD5Sum<sensor_msgs::CameraInfo> {};

template <>
struct MD5Sum<synthetic_dataset::motion::RecordedGrid> : MD5Sum<nav_msgs::OccupancyGrid> {};

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

}  // namespace serialization
}  // namespace ros
