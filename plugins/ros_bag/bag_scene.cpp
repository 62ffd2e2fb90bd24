#include "plugins/ros_bag/bag_scene.h"

namespace synthetic_dataset {

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

std::string recordOf(const BagScene& scene) {
  std::string record(ros::serialization::serializationLength(scene), '\0');
  ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(record.data()),
                                     static_cast<std::uint32_t>(record.size()));
  ros::serialization::serialize(stream, scene);
  return record;
}

BagScene bagSceneOf(const std::string& record) {
  std::string bytes = record;  // ROS's stream reads from memory that it might write to
  ros::serialization::IStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                     static_cast<std::uint32_t>(bytes.size()));
  BagScene scene;
  ros::serialization::deserialize(stream, scene);
  return scene;
}

}  // namespace synthetic_dataset
