#pragma once

#include <optional>
#include <string>
#include <vector>

#include <geometry_msgs/TransformStamped.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include "motion/bag_reader.h"

namespace synthetic_dataset::motion {

/// One bag, read message by message.
class BagFile {
 public:
  /// @throws Error: the file cannot be read as a bag; says why and what to do about it
  explicit BagFile(const std::string& file);
  BagFile(const BagFile&) = delete;
  BagFile& operator=(const BagFile&) = delete;

  [[nodiscard]] const std::string& file() const { return file_; }

  /// Nothing when the bag has no messages.
  [[nodiscard]] const std::optional<RecordedTimes>& times() const { return times_; }

  /// "/chatter (std_msgs/String), ..." of all topics with messages.
  [[nodiscard]] std::string topics();

  /// Whether another message of `/tf` or `/tf_static` is left.
  [[nodiscard]] bool hasMessage() const { return message_ != end_; }

  /// Its record time.
  [[nodiscard]] Stamp messageTime() const;
  [[nodiscard]] TransformKind messageKind() const;

  /// Reads its transforms and goes on to the next.
  /// @throws Error when the file is damaged there
  [[nodiscard]] std::vector<geometry_msgs::TransformStamped> takeMessage();

 private:
  void open();
  void checkTypes();

  std::string file_;
  rosbag::Bag bag_;
  rosbag::View all_;
  rosbag::View transforms_;
  rosbag::View::iterator message_, end_;
  std::optional<RecordedTimes> times_;
};

}  // namespace synthetic_dataset::motion
