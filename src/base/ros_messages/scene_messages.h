#pragma once

#include <string>
#include <vector>

#include <geometry_msgs/TransformStamped.h>
#include <sensor_msgs/CameraInfo.h>
#include <std_msgs/Header.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

#include "synthetic_dataset/scene.h"

/// Scenes as ROS messages, for bags and for topics; no ROS master is needed.
namespace synthetic_dataset::ros_messages {

/// Whether topic names may contain it: letters, digits, `_` and `/`. http://wiki.ros.org/Names
[[nodiscard]] bool isTopicLetter(char letter);

/// Turns names into unique, valid topic names: other characters become `_`, and duplicates get a
/// number at the end.
[[nodiscard]] std::vector<std::string> topicNames(const std::vector<std::string>& names);

/// The names of scenes' frames in messages; a prefix keeps them apart from the recording's frames.
class SceneFrames {
 public:
  /// @param prefix  of all frames but the global one
  SceneFrames(const std::string& global_frame, const std::string& prefix);

  [[nodiscard]] const std::string& globalFrame() const { return global_frame_; }
  [[nodiscard]] std::string of(const std::string& name) const;

 private:
  std::string global_frame_;
  std::string prefix_;
};

/// Which poses the scenes of a camera provide. For each instant, each pose should be provided once,
/// as tf2 warns of repeated poses.
struct CameraFrame {
  std::string name;         ///< of the optical frame, in the recording
  bool has_pose = true;     ///< whether they provide the pose of this frame
  bool has_objects = true;  ///< whether they provide the objects' poses
};

/// @throws Error if ROS cannot represent the time, as the functions below do
[[nodiscard]] std_msgs::Header headerOf(Stamp stamp, const std::string& frame);

/// Colours that differ however many classes there are: their hues are a golden ratio apart.
[[nodiscard]] std_msgs::ColorRGBA classColour(int class_id, float opacity);

[[nodiscard]] sensor_msgs::CameraInfo cameraInfo(const std_msgs::Header& header,
                                                 const CameraModel& camera);

/// The pose of a frame in that of the header.
[[nodiscard]] geometry_msgs::TransformStamped transform(const std_msgs::Header& header,
                                                        const std::string& child, const Pose& X_GB);

/// X_GC of the camera and X_GO of the objects, for `/tf`.
[[nodiscard]] tf2_msgs::TFMessage transforms(const Scene& scene, const CameraFrame& camera,
                                             const SceneFrames& frames);

/// A box and a name for each labelled object, in the global frame, after a marker that deletes
/// those shown before.
/// @throws Error also unless the scene has visible masks or visibility
[[nodiscard]] visualization_msgs::MarkerArray objectMarkers(const Scene& scene,
                                                            const SceneFrames& frames);

}  // namespace synthetic_dataset::ros_messages
