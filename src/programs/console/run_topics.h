#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/time.h>

#include "programs/console/console_reporter.h"

namespace synthetic_dataset::programs {

/// Reports to the console and, once a second, publishes a run's progress: on `/diagnostics`, and on
/// `~status` as JSON with `scenes_done`, `scenes`, `rate` [Hz], `time_left` [s] and `warnings`.
class RunTopics : public ConsoleReporter {
 public:
  /// The topics are opened only just before the first scene: until then, processes are forked.
  /// @param node  has to outlive this and all messages; made if it is empty
  explicit RunTopics(std::optional<ros::NodeHandle>& node) : node_(node) {}

  void warning(const std::string& message) override;
  void progress(std::int64_t scenes_done, std::int64_t scenes) override;

 private:
  void open();
  void publish();

  std::optional<ros::NodeHandle>& node_;
  ros::Publisher diagnostics_;
  ros::Publisher status_;
  ros::WallTime start_;
  ros::WallTime published_;
  std::int64_t scenes_done_ = 0;
  std::int64_t scenes_ = 0;
  std::int64_t warnings_ = 0;
  std::string last_warning_;
};

}  // namespace synthetic_dataset::programs
