#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>
#include <ros/subscriber.h>
#include <std_msgs/Float64.h>
#include <std_msgs/Int64.h>
#include <std_msgs/Time.h>

#include "programs/preview/preview_control.h"
#include "programs/preview/scene_topics.h"
#include "run/reporter.h"
#include "run/setup/input_cache.h"
#include "run/setup/run_setup.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// The node `preview`: makes the scenes of a run and publishes them instead of writing them.
///
/// Its services and topics are those of docs/preview.md. Callbacks may come in any thread; scenes
/// are made in the thread that calls run().
class PreviewNode {
 public:
  /// @param node  the handle in whose namespace the topics are
  /// @param read_settings  returns the settings, read again
  PreviewNode(ros::NodeHandle& node, std::function<Value()> read_settings);

  /// Shows scenes until ROS shuts down.
  void run();

 private:
  void offer(const std::string& service, std::function<void()> command);
  void jumpToTime(const std_msgs::Time& message);
  void setRate(const std_msgs::Float64& message);
  void carryOut(const PreviewControl::Order& order);
  void keepRun(const run::RunSetup& setup);
  void show(const Scene& scene);
  void publishStatus(const std::string& error = "");

  ros::NodeHandle& node_;
  std::function<Value()> read_settings_;
  Value settings_;
  run::InputCache inputs_;  ///< kept from one order to the next
  PreviewControl control_;
  SceneTopics topics_;
  std::mutex mutex_;            ///< guards times_, of_run_, shown_ and surroundings_
  std::vector<Stamp> times_;    ///< of the run's instants
  Value::Map of_run_;           ///< the part of the status that holds for all instants
  std::optional<Scene> shown_;  ///< without its pictures
  Value::Map surroundings_;     ///< the part of the status that says where the objects are
  ros::Publisher status_;
  std::vector<ros::ServiceServer> services_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace synthetic_dataset::programs
