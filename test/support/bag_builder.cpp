#include "support/bag_builder.h"

#include <cstdint>

#include <boost/make_shared.hpp>

#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>

namespace synthetic_dataset::test {

/// Has the fields of gazebo_msgs/ModelStates and LinkStates.
struct GazeboStates {
  std::vector<std::string> name;
  std::vector<geometry_msgs::Pose> pose;
  std::vector<geometry_msgs::Twist> twist;
};

}  // namespace synthetic_dataset::test

namespace ros {
namespace message_traits {

using synthetic_dataset::test::GazeboStates;

template <>
struct MD5Sum<GazeboStates> {
  static const char* value() { return "48c080191eb15c41858319b4d8a609c2"; }
  static const char* value(const GazeboStates& /*states*/) { return value(); }
};

template <>
struct DataType<GazeboStates> {
  static const char* value() { return "gazebo_msgs/ModelStates"; }
  static const char* value(const GazeboStates& /*states*/) { return value(); }
};

template <>
struct Definition<GazeboStates> {
  static const char* value() {
    return "string[] name\ngeometry_msgs/Pose[] pose\ngeometry_msgs/Twist[] twist\n";
  }
  static const char* value(const GazeboStates& /*states*/) { return value(); }
};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<synthetic_dataset::test::GazeboStates> {
  template <class Stream, class Message>
  static void allInOne(Stream& stream, Message message) {
    stream.next(message.name);
    stream.next(message.pose);
    stream.next(message.twist);
  }
  ROS_DECLARE_ALLINONE_SERIALIZER
};

}  // namespace serialization
}  // namespace ros

namespace synthetic_dataset::test {
namespace {

geometry_msgs::Pose toMessage(const Pose& X_PC) {
  const Eigen::Vector3d p = X_PC.translation();
  const Eigen::Quaterniond q(X_PC.linear());
  geometry_msgs::Pose pose;
  pose.position.x = p.x();
  pose.position.y = p.y();
  pose.position.z = p.z();
  pose.orientation.x = q.x();
  pose.orientation.y = q.y();
  pose.orientation.z = q.z();
  pose.orientation.w = q.w();
  return pose;
}

ros::Time toRosTime(Stamp stamp) {
  return ros::Time().fromNSec(static_cast<std::uint64_t>(stamp.count()));
}

rosbag::CompressionType toRosbag(Compression compression) {
  switch (compression) {
    case Compression::kBz2:
      return rosbag::compression::BZ2;
    case Compression::kLz4:
      return rosbag::compression::LZ4;
    case Compression::kNone:
      break;
  }
  return rosbag::compression::Uncompressed;
}

BagBuilder::Transform describe(const std::string& topic, const std::string& parent,
                               const std::string& child, Stamp stamp, const Pose& X_PC) {
  const Eigen::Vector3d p = X_PC.translation();
  const Eigen::Quaterniond q(X_PC.linear());
  return {topic, parent, child, stamp, stamp, p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()};
}

}  // namespace

struct BagBuilder::Impl {
  rosbag::Bag bag;
  std::uint32_t width = 160;  // of a camera's images [px]
  std::uint32_t height = 120;
  std::string frame;  // of pictures, depth images and clouds
};

Pose poseAt(double x, double y, double z, double yaw) {
  return makePose({x, y, z}, Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ())));
}

BagBuilder::BagBuilder(const std::filesystem::path& file, Compression compression)
    : impl_(new Impl) {
  impl_->bag.open(file.string(), rosbag::bagmode::Write);
  impl_->bag.setCompression(toRosbag(compression));
}

BagBuilder::~BagBuilder() = default;

BagBuilder& BagBuilder::move(const std::string& parent, const std::string& child, Stamp stamp,
                             const Pose& X_PC) {
  return add(describe("/tf", parent, child, stamp, X_PC));
}

BagBuilder& BagBuilder::fix(const std::string& parent, const std::string& child, Stamp stamp,
                            const Pose& X_PC) {
  return add(describe("/tf_static", parent, child, stamp, X_PC));
}

BagBuilder& BagBuilder::add(const Transform& transform) {
  geometry_msgs::TransformStamped stamped;
  stamped.header.frame_id = transform.parent;
  stamped.header.stamp = toRosTime(transform.stamp);
  stamped.child_frame_id = transform.child;
  stamped.transform.translation.x = transform.x;
  stamped.transform.translation.y = transform.y;
  stamped.transform.translation.z = transform.z;
  stamped.transform.rotation.x = transform.qx;
  stamped.transform.rotation.y = transform.qy;
  stamped.transform.rotation.z = transform.qz;
  stamped.transform.rotation.w = transform.qw;
  tf2_msgs::TFMessage message;
  message.transforms.push_back(stamped);
  boost::shared_ptr<ros::M_string> header;
  if (!transform.publisher.empty()) {
    using Traits = ros::message_traits::MD5Sum<tf2_msgs::TFMessage>;
    header = boost::make_shared<ros::M_string>();
    (*header)["callerid"] = transform.publisher;
    (*header)["topic"] = transform.topic;
    (*header)["type"] = "tf2_msgs/TFMessage";
    (*header)["md5sum"] = Traits::value();
    (*header)["message_definition"] = ros::message_traits::definition(message);
  }
  impl_->bag.write(transform.topic, toRosTime(transform.recorded), message, header);
  return *this;
}

BagBuilder& BagBuilder::drive(const std::string& topic, const std::string& parent,
                              const std::string& child, Stamp stamp, const Pose& X_PC) {
  nav_msgs::Odometry message;
  message.header.frame_id = parent;
  message.header.stamp = toRosTime(stamp);
  message.child_frame_id = child;
  message.pose.pose = toMessage(X_PC);
  impl_->bag.write(topic, toRosTime(stamp), message);
  return *this;
}

BagBuilder& BagBuilder::locate(const std::string& topic, const std::string& parent, Stamp stamp,
                               const Pose& X_PC) {
  geometry_msgs::PoseStamped message;
  message.header.frame_id = parent;
  message.header.stamp = toRosTime(stamp);
  message.pose = toMessage(X_PC);
  impl_->bag.write(topic, toRosTime(stamp), message);
  return *this;
}

BagBuilder& BagBuilder::locateAll(const std::string& topic, const std::string& parent, Stamp stamp,
                                  const std::vector<Pose>& poses) {
  geometry_msgs::PoseArray message;
  message.header.frame_id = parent;
  message.header.stamp = toRosTime(stamp);
  for (const Pose& X_PC : poses) message.poses.push_back(toMessage(X_PC));
  impl_->bag.write(topic, toRosTime(stamp), message);
  return *this;
}

BagBuilder& BagBuilder::bend(const std::string& topic, Stamp stamp,
                             const std::map<std::string, double>& positions) {
  sensor_msgs::JointState message;
  message.header.stamp = toRosTime(stamp);
  for (const auto& [joint, position] : positions) {
    message.name.push_back(joint);
    message.position.push_back(position);
  }
  impl_->bag.write(topic, toRosTime(stamp), message);
  return *this;
}

BagBuilder& BagBuilder::simulate(const std::string& topic, const std::string& type, Stamp recorded,
                                 const std::map<std::string, Pose>& X_WM) {
  GazeboStates states;
  for (const auto& [name, pose] : X_WM) {
    states.name.push_back(name);
    states.pose.push_back(toMessage(pose));
    states.twist.emplace_back();
  }
  const auto header = boost::make_shared<ros::M_string>();
  (*header)["topic"] = topic;
  (*header)["type"] = type;
  (*header)["md5sum"] = ros::message_traits::md5sum(states);
  (*header)["message_definition"] = ros::message_traits::definition(states);
  impl_->bag.write(topic, toRosTime(recorded), states, header);
  return *this;
}

BagBuilder& BagBuilder::say(const std::string& topic, Stamp recorded, const std::string& text) {
  std_msgs::String message;
  message.data = text;
  impl_->bag.write(topic, toRosTime(recorded), message);
  return *this;
}

BagBuilder& BagBuilder::calibrate(const std::string& topic, const std::string& frame,
                                  Stamp recorded, double focal_length,
                                  const std::vector<double>& distortion) {
  sensor_msgs::CameraInfo info;
  info.header.frame_id = frame;
  info.header.stamp = toRosTime(recorded);
  info.width = impl_->width;
  info.height = impl_->height;
  info.distortion_model = "plumb_bob";
  info.D = distortion;
  const double cx = 0.5 * (info.width - 1);
  const double cy = 0.5 * (info.height - 1);
  info.K = {focal_length, 0, cx, 0, focal_length, cy, 0, 0, 1};
  info.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  info.P = {focal_length, 0, cx, 0, 0, focal_length, cy, 0, 0, 0, 1, 0};
  impl_->bag.write(topic, toRosTime(recorded), info);
  return *this;
}

BagBuilder& BagBuilder::picture(const std::string& topic, Stamp stamp, const cv::Mat& pixels,
                                const std::string& encoding) {
  sensor_msgs::Image image;
  image.header.frame_id = impl_->frame;
  image.header.stamp = toRosTime(stamp);
  image.width = static_cast<std::uint32_t>(pixels.cols);
  image.height = static_cast<std::uint32_t>(pixels.rows);
  image.encoding = encoding;
  image.step = static_cast<std::uint32_t>(pixels.step[0]);
  image.data.assign(pixels.datastart, pixels.dataend);
  impl_->bag.write(topic, image.header.stamp, image);
  return *this;
}

BagBuilder& BagBuilder::pictureAt(const std::string& topic, Stamp recorded, Stamp stamp) {
  sensor_msgs::Image image;
  image.header.stamp = toRosTime(stamp);
  image.width = image.height = image.step = 1;
  image.encoding = "mono8";
  image.data = {100};
  impl_->bag.write(topic, toRosTime(recorded), image);
  return *this;
}

BagBuilder& BagBuilder::pictureFile(const std::string& topic, Stamp stamp,
                                    const std::string& format,
                                    const std::vector<std::uint8_t>& bytes) {
  sensor_msgs::CompressedImage image;
  image.header.frame_id = impl_->frame;
  image.header.stamp = toRosTime(stamp);
  image.format = format;
  image.data = bytes;
  impl_->bag.write(topic, image.header.stamp, image);
  return *this;
}

BagBuilder& BagBuilder::from(const std::string& frame) {
  impl_->frame = frame;
  return *this;
}

BagBuilder& BagBuilder::cloud(const std::string& topic, Stamp stamp,
                              const std::vector<Eigen::Vector3d>& points) {
  sensor_msgs::PointCloud2 message;
  message.header.frame_id = impl_->frame;
  message.header.stamp = toRosTime(stamp);
  message.height = 1;
  message.width = static_cast<std::uint32_t>(points.size());
  for (const char* const name : {"x", "y", "z"}) {
    sensor_msgs::PointField field;
    field.name = name;
    field.offset = static_cast<std::uint32_t>(message.fields.size() * sizeof(float));
    field.datatype = sensor_msgs::PointField::FLOAT32;
    field.count = 1;
    message.fields.push_back(field);
  }
  message.point_step = 3 * sizeof(float);
  message.row_step = message.point_step * message.width;
  for (const Eigen::Vector3d& point : points) {
    for (const double each : {point.x(), point.y(), point.z()}) {
      const auto number = static_cast<float>(each);
      const auto* const bytes = reinterpret_cast<const std::uint8_t*>(&number);
      message.data.insert(message.data.end(), bytes, bytes + sizeof number);
    }
  }
  return cloud(topic, message);
}

BagBuilder& BagBuilder::cloud(const std::string& topic, const sensor_msgs::PointCloud2& message) {
  impl_->bag.write(topic, message.header.stamp, message);
  return *this;
}

BagBuilder& BagBuilder::resizeCamera(std::uint32_t width, std::uint32_t height) {
  impl_->width = width;
  impl_->height = height;
  return *this;
}

BagBuilder& BagBuilder::map(const Map& map) {
  const Eigen::Vector3d p_FM = map.X_FM.translation();
  const Eigen::Quaterniond q_FM(map.X_FM.linear());
  nav_msgs::OccupancyGrid grid;
  grid.header.frame_id = map.frame;
  grid.header.stamp = toRosTime(map.recorded);
  grid.info.width = map.width;
  grid.info.height = map.height;
  grid.info.resolution = map.resolution;
  grid.info.origin.position.x = p_FM.x();
  grid.info.origin.position.y = p_FM.y();
  grid.info.origin.position.z = p_FM.z();
  grid.info.origin.orientation.x = q_FM.x();
  grid.info.origin.orientation.y = q_FM.y();
  grid.info.origin.orientation.z = q_FM.z();
  grid.info.origin.orientation.w = q_FM.w();
  grid.data = map.cells;
  impl_->bag.write(map.topic, toRosTime(map.recorded), grid);
  return *this;
}

BagBuilder& BagBuilder::splitChunks() {
  impl_->bag.setChunkThreshold(1);
  return *this;
}

std::string BagBuilder::close() {
  const std::string file = impl_->bag.getFileName();
  impl_->bag.close();
  return file;
}

}  // namespace synthetic_dataset::test
