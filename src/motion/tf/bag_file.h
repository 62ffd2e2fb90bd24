#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include <geometry_msgs/TransformStamped.h>
#include <rosbag/bag.h>
#include <rosbag/message_instance.h>
#include <rosbag/view.h>

#include "motion/bag/bag_check.h"
#include "motion/tf/left_out_transforms.h"
#include "motion/tf/recorded_transform.h"

namespace synthetic_dataset::motion {

/// How the messages of a topic become transforms.
struct TopicReader {
  TransformKind kind = TransformKind::kMoving;
  std::function<std::vector<geometry_msgs::TransformStamped>(const rosbag::MessageInstance&)> read;
};

/// By topic, as the bags spell it.
using TopicReaders = std::map<std::string, TopicReader>;

/// When a recording was made: the record times of its first and last message, of any topic.
struct RecordedTimes {
  Stamp start{0};
  Stamp end{0};
};

/// A topic with messages of one type.
struct BagTopic {
  std::string name;
  std::string type;
  std::string md5sum;
};

/// One bag, read message by message.
class BagFile {
 public:
  /// @param number  among the bags of a recording
  /// @throws Error: the file cannot be read as a bag; says why and what to do about it
  BagFile(const std::string& file, std::uint32_t number);
  BagFile(const BagFile&) = delete;
  BagFile& operator=(const BagFile&) = delete;

  [[nodiscard]] const std::string& file() const { return file_; }

  /// Nothing when the bag has no messages.
  [[nodiscard]] const std::optional<RecordedTimes>& times() const { return times_; }

  [[nodiscard]] const std::vector<BagTopic>& topics() const { return topics_; }

  /// Goes to the first message of these topics. Call it before what follows.
  /// @param readers  have to outlive the reading
  /// @throws Error when the file is damaged there
  void select(const TopicReaders& readers);

  /// Whether another message of the selected topics is left.
  [[nodiscard]] bool hasMessage() const { return message_ != end_; }

  /// Its record time.
  [[nodiscard]] Stamp messageTime() const;

  /// Reads its transforms and goes on to the next.
  /// @throws Error when the file is damaged there
  [[nodiscard]] std::vector<RecordedTransform> takeMessage();

 private:
  void open();
  void findArrivals(const MessagePlaces& places);
  [[nodiscard]] Arrival nextArrival();

  /// @throws Error: the bag is damaged
  template <class Read>
  auto reading(const Read& read) const -> decltype(read());

  std::string file_;
  std::uint32_t number_;
  rosbag::Bag bag_;
  rosbag::View all_;
  std::vector<BagTopic> topics_;
  std::optional<RecordedTimes> times_;

  const TopicReaders* readers_ = nullptr;
  std::optional<rosbag::View> selected_;
  rosbag::View::iterator message_, end_;
  struct Connection {
    std::vector<Arrival> arrivals;  ///< of its messages, in the order of the view
    std::size_t next = 0;
  };
  std::unordered_map<const void*, Connection> connections_;  ///< by their headers
};

}  // namespace synthetic_dataset::motion
