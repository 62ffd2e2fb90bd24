#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <rosbag/message_instance.h>
#include <boost/make_shared.hpp>
#include <boost/shared_ptr.hpp>

#include "motion/bag/bag_check.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// When a recording was made: the record times of its first and last message, of any topic.
struct RecordedTimes {
  Stamp start{0};
  Stamp end{0};
};

/// A topic with messages of one type.
struct BagTopic {
  std::string name;
  std::string type;          ///< as ROS 1 spells it: "nav_msgs/Odometry"
  std::string md5sum;        ///< of ROS 1's type; empty if the type is not known
  std::string problem = {};  ///< why its messages cannot be read although the type is known
};

/// A message of a bag. Its content is read on demand; the bag has to live until then.
struct BagMessage {
  std::string topic;
  Stamp recorded{0};    ///< its record time
  Stamp not_before{0};  ///< the latest record time of it and of those before it in the file
  MessagePlace place = 0;
  std::string publisher = {};  ///< the node's name; empty if the bag does not say

  std::shared_ptr<const rosbag::MessageInstance> ros1 = {};  ///< its content, or else:
  std::string md5sum = {};                                   ///< of its type
  std::function<std::string()> bytes = {};                   ///< its content as serialised by ROS 1

  /// @return null if it is of another type
  template <class Message>
  [[nodiscard]] boost::shared_ptr<Message> instantiate() const {
    if (ros1) return ros1->instantiate<Message>();
    if (md5sum != ros::message_traits::MD5Sum<Message>::value()) return {};
    std::string content = bytes();
    ros::serialization::IStream stream(reinterpret_cast<std::uint8_t*>(content.data()),
                                       static_cast<std::uint32_t>(content.size()));
    auto message = boost::make_shared<Message>();
    ros::serialization::deserialize(stream, *message);
    return message;
  }
};

/// Iterates over messages of a bag, in the order of their record times.
class BagMessages {
 public:
  virtual ~BagMessages() = default;

  /// The record time of the next one; nothing at the end.
  [[nodiscard]] virtual std::optional<Stamp> nextTime() const = 0;

  /// Returns the next message and advances; nothing at the end.
  [[nodiscard]] virtual std::optional<BagMessage> next() = 0;
};

/// A recording: a bag of ROS 1 or of ROS 2.
class Bag {
 public:
  virtual ~Bag() = default;

  /// Sorted by name; each pair of name and type once.
  [[nodiscard]] virtual const std::vector<BagTopic>& topics() const = 0;

  /// Nothing if there are no messages.
  [[nodiscard]] virtual const std::optional<RecordedTimes>& times() const = 0;

  /// "ROS 1", or "ROS 2 (mcap, zstd, 3 files)".
  [[nodiscard]] virtual std::string kind() const = 0;

  /// What the user should know about it: where it breaks off, for example.
  [[nodiscard]] virtual std::vector<std::string> notes() const { return {}; }

  /// @param is_read  whether messages of a topic are wanted
  /// @param recorded  only messages recorded at this time; nothing: at any time
  /// @return the messages; the bag has to outlive them
  /// @throws Error naming the bag, if it is damaged
  [[nodiscard]] virtual std::unique_ptr<BagMessages> messages(
      const TopicFilter& is_read, std::optional<Stamp> recorded = std::nullopt) = 0;

  /// How to repair a damaged bag, for the end of a message: "; `rosbag reindex a.bag` mends ...";
  /// or nothing.
  [[nodiscard]] virtual std::string advice() const { return ""; }
};

/// Whether a path may be a bag: it has a bag's file name (.bag, .db3, .mcap), or is a bag of ROS 2.
[[nodiscard]] bool isBagPath(const std::string& path);

/// Opens a bag: a file of ROS 1, or a file or folder of ROS 2.
/// @throws Error naming the bag, if it cannot be read as one; says why and what to do about it
[[nodiscard]] std::unique_ptr<Bag> openBag(const std::string& path);

}  // namespace synthetic_dataset::motion
