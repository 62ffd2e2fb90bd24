#pragma once

#include <cstdint>
#include <string>

#include <ros/serialization.h>
#include <ros/time.h>
#include <sensor_msgs/CameraInfo.h>
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

}  // namespace synthetic_dataset

namespace ros::serialization {

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
