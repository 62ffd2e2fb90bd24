#include "programs/console/run_topics.h"

#include <ros/this_node.h>
#include <std_msgs/String.h>

#include "base/json_text.h"
#include "programs/console/script_reporter.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::programs {
namespace {

diagnostic_msgs::KeyValue entryOf(const std::string& key, const std::string& text) {
  diagnostic_msgs::KeyValue entry;
  entry.key = key;
  entry.value = text;
  return entry;
}

}  // namespace

void RunTopics::open() {
  if (!node_) node_.emplace();
  ros::NodeHandle own("~");
  diagnostics_ = own.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 10);
  status_ = own.advertise<std_msgs::String>("status", 10, true);
  start_ = ros::WallTime::now();
}

void RunTopics::warning(const std::string& message) {
  ConsoleReporter::warning(message);
  ++warnings_;
  last_warning_ = message;
}

void RunTopics::progress(std::int64_t scenes_done, std::int64_t scenes) {
  ConsoleReporter::progress(scenes_done, scenes);
  if (start_.isZero()) open();
  const ros::WallTime now = ros::WallTime::now();
  scenes_done_ = scenes_done;
  scenes_ = scenes;
  constexpr double kPeriod = 1.0;  // [s]
  const bool is_end = scenes_done == scenes;
  if (!is_end && !published_.isZero() && (now - published_).toSec() < kPeriod) return;
  published_ = now;
  publish();
}

void RunTopics::publish() {
  const double seconds = (published_ - start_).toSec();
  const double rate = seconds > 0.0 ? static_cast<double>(scenes_done_) / seconds : 0.0;
  const double left = rate > 0.0 ? static_cast<double>(scenes_ - scenes_done_) / rate : 0.0;

  std_msgs::String text;
  text.data = base::jsonText(progressValue(scenes_done_, scenes_, seconds, warnings_));
  status_.publish(text);

  diagnostic_msgs::DiagnosticStatus status;
  using Status = diagnostic_msgs::DiagnosticStatus;
  status.level = warnings_ > 0 ? Status::WARN : Status::OK;
  status.name = ros::this_node::getName().substr(1) + ": dataset";
  status.message = std::to_string(scenes_done_) + " of " + std::to_string(scenes_) + " scenes" +
                   (last_warning_.empty() ? "" : "; " + last_warning_);
  status.values = {
      entryOf("scenes done", std::to_string(scenes_done_)),
      entryOf("scenes", std::to_string(scenes_)), entryOf("scenes per second", fixed(rate, 2)),
      entryOf("time left [s]", fixed(left, 1)), entryOf("warnings", std::to_string(warnings_))};
  diagnostic_msgs::DiagnosticArray message;
  message.header.stamp = ros::Time::now();
  message.status.push_back(status);
  diagnostics_.publish(message);
}

}  // namespace synthetic_dataset::programs
