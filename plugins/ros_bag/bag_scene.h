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

/// What a ROS bag holds of a scene beside its pictures: what is kept from the scene to the bag.
struct BagScene {
  std::uint32_t camera_index = 0;
  ros::Time stamp;
  std::string name;  ///< Scene::name
  sensor_msgs::CameraInfo camera_info;
  tf2_msgs::TFMessage transforms;
  visualization_msgs::MarkerArray objects;
};

/// @throws Error when ROS has no such time
[[nodiscard]] BagScene makeBagScene(const Scene& scene, const ros_messages::CameraFrame& camera,
                                    const ros_messages::SceneFrames& frames);

/// As ROS serialises messages; `bagSceneOf` is the way back.
[[nodiscard]] std::string recordOf(const BagScene& scene);
[[nodiscard]] BagScene bagSceneOf(const std::string& record);

/// A lidar's sweep in a ROS bag: what is kept beside the file that has its points.
struct BagCloud {
  std::uint32_t lidar = 0;  ///< its index in DatasetInfo::lidars
  std::string file;         ///< with the message, as ROS serialises it
  geometry_msgs::TransformStamped transform;
};

[[nodiscard]] std::string recordOf(const BagCloud& cloud);
[[nodiscard]] BagCloud bagCloudOf(const std::string& record);

/// An organised cloud, a row a ring and a column a time: `x`, `y`, `z` [m] as they were measured,
/// not a number where nothing was; `intensity`, 0 .. 255; `time` since the header's stamp [s];
/// `ring`; `label`, the class's number from 1, those of the world after those of objects, 0 for
/// none; `instance`, the object's number from 1.
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
