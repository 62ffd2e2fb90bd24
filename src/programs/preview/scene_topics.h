#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <std_msgs/Header.h>
#include <visualization_msgs/Marker.h>

#include "base/ros_messages/scene_messages.h"
#include "run/setup/run_setup.h"
#include "synthetic_dataset/label_writer.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::programs {

/// The topics of a preview: below the node's name those of each camera (`CAMERA/image_raw`,
/// `camera_info`, `image_labels`, `depth/image_raw`, `depth/camera_info`, `instances`) and
/// `labels`, `views`, `ways`, `clouds`, `world` for RViz; `/tf`. All but the last are latched, so
/// that late subscribers receive what is shown.
class SceneTopics {
 public:
  /// @param on_missing  called, in the thread of callbacks, when somebody subscribes to a topic for
  ///     which nothing was made
  SceneTopics(ros::NodeHandle& node, const std::string& frame_prefix,
              std::function<void()> on_missing);

  /// Makes the topics of a run's cameras, and shows the world and the objects' paths.
  void open(const run::RunSetup& setup);

  /// The prefix of each camera's topics, in the order of the cameras.
  [[nodiscard]] const std::vector<std::string>& cameraTopics() const { return camera_topics_; }

  /// What each scene has to contain for those who subscribe now. From now on, this counts as what
  /// is made.
  [[nodiscard]] Requirements takeRequirements();

  /// Publishes what was made of a scene, stamped with the current wall-clock time: a preview also
  /// goes back in time, which TF listeners do not tolerate.
  void show(const Scene& scene);

 private:
  struct Camera {
    std::string name;
    ros_messages::CameraFrame frame;
    ros::Publisher image;
    ros::Publisher info;
    ros::Publisher labelled;
    ros::Publisher depth;
    ros::Publisher depth_info;
    ros::Publisher instances;
  };

  /// @param is_made  whether the topic's content is made already; empty: it always is
  template <class Message>
  [[nodiscard]] ros::Publisher advertise(const std::string& topic,
                                         std::function<bool()> is_made = {});
  void showWorld(const world::World& world);
  void addCamera(const std::string& name, const std::string& topic,
                 const ros_messages::CameraFrame& frame);
  void showLabels(const Scene& scene, const Camera& camera, const std_msgs::Header& header);

  ros::NodeHandle& node_;
  std::string frame_prefix_;
  std::function<void()> on_missing_;
  ros_messages::SceneFrames frames_;
  std::vector<Camera> cameras_;
  std::vector<std::string> camera_topics_;
  std::mutex mutex_;
  Requirements made_;  ///< what is made of each scene
  bool shows_world_ = false;
  bool has_lidars_ = false;
  std::vector<visualization_msgs::Marker> views_;  ///< of all cameras, at the instant shown
  ros::Publisher transforms_;
  ros::Publisher labels_;
  ros::Publisher view_markers_;
  ros::Publisher ways_;
  ros::Publisher clouds_;
  ros::Publisher world_;
};

}  // namespace synthetic_dataset::programs
