#pragma once

#include <cstdint>
#include <string>

#include <geometry_msgs/TransformStamped.h>
#include <ros/serialization.h>
#include <ros/time.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include "base/ros_messages/scene_messages.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset {

/// The contents of a ROS bag for a scene besides its pictures, kept until the bag is written.
struct BagScene {
  std::uint32_t camera_index = 0;
  ros::Time stamp;
  std::string name;  ///< Scene::name
  sensor_msgs::CameraInfo camera_info;
  tf2_msgs::TFMessage transforms;
  visualization_msgs::MarkerArray objects;
};

/// @throws Error if ROS cannot represent the time
[[nodiscard]] BagScene makeBagScene(const Scene& scene, const ros_messages::CameraFrame& camera,
                                    const ros_messages::SceneFrames& frames);

/// Serialises in the way of ROS messages; `bagSceneOf` is the inverse.
[[nodiscard]] std::string recordOf(const BagScene& scene);
[[nodiscard]] BagScene bagSceneOf(const std::string& record);

/// A lidar's sweep in a ROS bag: what is kept besides the file with its points.
struct BagCloud {
  std::uint32_t lidar = 0;  ///< its index in DatasetInfo::lidars
  std::string file;         ///< contains the message, as serialised by ROS
  geometry_msgs::TransformStamped transform;
};

[[nodiscard]] std::string recordOf(const BagCloud& cloud);
[[nodiscard]] BagCloud bagCloudOf(const std::string& record);

/// An organised cloud with one row per ring and one column per time: `x`, `y`, `z` [m] as measured,
/// NaN where there was nothing; `intensity`, 0 .. 255; `time` since the header's stamp [s]; `ring`;
/// `label`, the class's number from 1, world classes after those of objects, 0 for none;
/// `instance`, the object's number from 1.
/// @param object_classes  how many there are
[[nodiscard]] sensor_msgs::PointCloud2 cloudMessage(const std_msgs::Header& header,
                                                    const Cloud& cloud, std::size_t object_classes);

[[nodiscard]] std::string bytesOf(const sensor_msgs::PointCloud2& message);
[[nodiscard]] sensor_msgs::PointCloud2 cloudIn(const std::string& bytes);

}  // namespace synthetic_dataset

namespace ros::serialization {

template <>
struct Serializer<synthetic_dataset::BagCloud> {
  template <typename Stream, typename Cloud>
  inline static void allInOne(Stream& stream, Cloud cloud) {
    stream.next(cloud.lidar);
    stream.next(cloud.file);
    stream.next(cloud.transform);
  }

  ROS_DECLARE_ALLINONE_SERIALIZER
};

template <>
struct Serializer<synthetic_dataset::BagScene> {
  template <typename Stream, typename Scene>
  inline static void allInOne(Stream& stream, Scene scene) {
    stream.next(scene.camera_index);
    stream.next(scene.stamp);
    stream.next(scene.name);
    stream.next(scene.camera_info);
    stream.next(scene.transforms);
    stream.next(scene.objects);
  }

  ROS_DECLARE_ALLINONE_SERIALIZER
};

}  // namespace ros::serialization
