#include "plugins/ros_bag/bag_scene.h"

#include <cstring>
#include <limits>

#include <sensor_msgs/PointField.h>

namespace synthetic_dataset {
namespace {

template <class Message>
std::string serialized(const Message& message) {
  std::string bytes(ros::serialization::serializationLength(message), '\0');
  ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                     static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

template <class Message>
Message deserialized(std::string bytes) {  // ROS's stream needs non-const memory
  ros::serialization::IStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                     static_cast<std::uint32_t>(bytes.size()));
  Message message;
  ros::serialization::deserialize(stream, message);
  return message;
}

// Byte offsets of a point's fields after x, y and z.
constexpr std::uint32_t kIntensity = 12;
constexpr std::uint32_t kTime = 16;
constexpr std::uint32_t kRing = 20;
constexpr std::uint32_t kLabel = 22;
constexpr std::uint32_t kInstance = 24;
constexpr std::uint32_t kPointBytes = 28;

void addFields(sensor_msgs::PointCloud2& message) {
  using sensor_msgs::PointField;
  const auto add = [&](const char* name, std::uint32_t offset, std::uint8_t type) {
    PointField& field = message.fields.emplace_back();
    field.name = name;
    field.offset = offset;
    field.datatype = type;
    field.count = 1;
  };
  add("x", 0, PointField::FLOAT32);
  add("y", 4, PointField::FLOAT32);
  add("z", 8, PointField::FLOAT32);
  add("intensity", kIntensity, PointField::FLOAT32);
  add("time", kTime, PointField::FLOAT32);
  add("ring", kRing, PointField::UINT16);
  add("label", kLabel, PointField::UINT16);
  add("instance", kInstance, PointField::UINT16);
  message.point_step = kPointBytes;
}

/// Little-endian, like all supported processors.
template <class Number>
void put(Number number, std::uint8_t* bytes) {
  std::memcpy(bytes, &number, sizeof number);
}

}  // namespace

BagScene makeBagScene(const Scene& scene, const ros_messages::CameraFrame& camera,
                      const ros_messages::SceneFrames& frames) {
  BagScene result;
  result.camera_index = static_cast<std::uint32_t>(scene.camera_index);
  result.name = scene.name;
  result.camera_info = ros_messages::cameraInfo(
      ros_messages::headerOf(scene.stamp, frames.of(camera.name)), scene.camera);
  result.stamp = result.camera_info.header.stamp;
  result.transforms = ros_messages::transforms(scene, camera, frames);
  result.objects = ros_messages::objectMarkers(scene, frames);
  return result;
}

std::string recordOf(const BagScene& scene) { return serialized(scene); }

BagScene bagSceneOf(const std::string& record) { return deserialized<BagScene>(record); }

std::string recordOf(const BagCloud& cloud) { return serialized(cloud); }

BagCloud bagCloudOf(const std::string& record) { return deserialized<BagCloud>(record); }

std::string bytesOf(const sensor_msgs::PointCloud2& message) { return serialized(message); }

sensor_msgs::PointCloud2 cloudIn(const std::string& bytes) {
  return deserialized<sensor_msgs::PointCloud2>(bytes);
}

sensor_msgs::PointCloud2 cloudMessage(const std_msgs::Header& header, const Cloud& cloud,
                                      std::size_t object_classes) {
  sensor_msgs::PointCloud2 message;
  message.header = header;
  message.height = static_cast<std::uint32_t>(cloud.rings);
  message.width = static_cast<std::uint32_t>(cloud.columns);
  addFields(message);
  message.row_step = message.point_step * message.width;
  message.is_bigendian = 0U;
  message.is_dense = 0U;
  message.data.resize(std::size_t{message.row_step} * message.height);
  constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
  for (std::uint32_t ring = 0; ring < message.height; ++ring) {
    for (std::uint32_t column = 0; column < message.width; ++column) {
      std::uint8_t* cell = &message.data[std::size_t{ring} * message.row_step +
                                         std::size_t{column} * message.point_step];
      for (std::size_t axis = 0; axis < 3; ++axis) put(kNothing, cell + 4 * axis);
      put(static_cast<std::uint16_t>(ring), cell + kRing);
    }
  }
  for (const CloudPoint& point : cloud.points) {
    std::uint8_t* cell = &message.data[std::size_t{point.ring} * message.row_step +
                                       std::size_t{point.column} * message.point_step];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      put(point.position_S[static_cast<Eigen::Index>(axis)], cell + 4 * axis);
    }
    constexpr float kFull = 255.0F;  // as in Velodyne's driver
    put(kFull * point.intensity, cell + kIntensity);
    put(static_cast<float>(1e-9 * point.time), cell + kTime);
    const std::size_t of_world = point.world_class > 0 ? object_classes + point.world_class : 0;
    put(point.class_number > 0 ? point.class_number : static_cast<std::uint16_t>(of_world),
        cell + kLabel);
    put(point.instance, cell + kInstance);
  }
  return message;
}

}  // namespace synthetic_dataset
