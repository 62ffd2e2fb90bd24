#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <geometry_msgs/TransformStamped.h>

#include "motion/bag/bag.h"
#include "motion/tf/left_out_transforms.h"
#include "motion/tf/recorded_transform.h"

namespace synthetic_dataset::motion {

/// How the messages of a topic become transforms.
struct TopicReader {
  TransformKind kind = TransformKind::kMoving;
  std::function<std::vector<geometry_msgs::TransformStamped>(const BagMessage&)> read;
};

/// By topic, as spelt in the bags.
using TopicReaders = std::map<std::string, TopicReader>;

/// One bag, read message by message.
class BagFile {
 public:
  /// @param number  index among the bags of a recording
  /// @throws Error if the file cannot be read as a bag; says why and what to do about it
  BagFile(const std::string& file, std::uint32_t number)
      : file_(file), number_(number), bag_(openBag(file)) {}
  BagFile(const BagFile&) = delete;
  BagFile& operator=(const BagFile&) = delete;

  [[nodiscard]] const std::string& file() const { return file_; }

  /// Nothing if the bag has no messages.
  [[nodiscard]] const std::optional<RecordedTimes>& times() const { return bag_->times(); }

  [[nodiscard]] const std::vector<BagTopic>& topics() const { return bag_->topics(); }

  [[nodiscard]] std::string kind() const { return bag_->kind(); }

  /// What the user should know about the bag.
  [[nodiscard]] std::vector<std::string> notes() const { return bag_->notes(); }

  /// Goes to the first message of these topics. Has to be called before messageTime() and
  /// takeMessage().
  /// @param readers  have to outlive the reading
  /// @throws Error if the file is damaged there
  void select(const TopicReaders& readers);

  /// The record time of the next message of the selected topics; nothing at the end.
  [[nodiscard]] std::optional<Stamp> messageTime() const { return messages_->nextTime(); }

  /// Reads the transforms of the next message, and advances.
  /// @throws Error if the file is damaged there
  [[nodiscard]] std::vector<RecordedTransform> takeMessage();

 private:
  std::string file_;
  std::uint32_t number_;
  std::unique_ptr<Bag> bag_;
  const TopicReaders* readers_ = nullptr;
  std::unique_ptr<BagMessages> messages_;
};

}  // namespace synthetic_dataset::motion
