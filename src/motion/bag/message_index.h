#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "motion/bag/bag.h"
#include "motion/bag/topic_search.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// Where the messages of a topic are in bags that count as one recording, by the stamps of their
/// headers.
class MessageIndex {
 public:
  /// Looks at a message, and says which stamp it has.
  using Look = std::function<Stamp(const BagMessage& message)>;

  /// Looks at all messages of the topic, in the order in which they were recorded.
  /// @param bag_files  bags that can be read
  /// @param noun  what a message is, for messages to the user: "picture"
  /// @throws Error when no bag has such a topic, it has messages of another type, its messages have
  ///     no stamps, or their time goes back
  MessageIndex(const std::vector<std::string>& bag_files, const std::string& topic,
               const std::string& noun, TopicSearch search, const Look& look);
  ~MessageIndex();
  MessageIndex(MessageIndex&&) noexcept;
  MessageIndex& operator=(MessageIndex&&) noexcept;

  /// How many were left out since they have the stamp of another one.
  [[nodiscard]] std::int64_t repeatedCount() const;

  /// What was noted of each message that was looked at, as the messages are here: by their stamps,
  /// of equal ones the first that was recorded.
  template <class Noted>
  [[nodiscard]] std::vector<Noted> inOrder(std::vector<Noted> looked_at) const {
    std::vector<Noted> ordered;
    for (const std::size_t index : order()) ordered.push_back(std::move(looked_at[index]));
    return ordered;
  }

  /// Shows a message again, in any thread.
  /// @throws Error naming the bag that cannot be read any more
  void read(std::size_t index, const std::function<void(const BagMessage& message)>& see) const;

 private:
  /// Which of the messages that were looked at is here.
  [[nodiscard]] const std::vector<std::size_t>& order() const;

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The messages of a topic, with what is known of each without keeping its content.
/// @tparam Head  what that is, among it the message's `stamp`
template <class Head>
class RecordedMessages {
 public:
  /// All of them in order of stamp, the first recorded one of equal stamps; at least one.
  [[nodiscard]] const std::vector<Head>& heads() const { return heads_; }

  /// How many were left out since they have the stamp of another one.
  [[nodiscard]] std::int64_t repeatedCount() const { return index_.repeatedCount(); }

 protected:
  /// @param head_of  looks at a message; all else as MessageIndex has it
  RecordedMessages(const std::vector<std::string>& bag_files, const std::string& topic,
                   const std::string& noun, TopicSearch search,
                   const std::function<Head(const BagMessage& message)>& head_of)
      : index_(bag_files, topic, noun, std::move(search), [&](const BagMessage& message) {
          heads_.push_back(head_of(message));
          return heads_.back().stamp;
        }) {
    heads_ = index_.inOrder(std::move(heads_));
  }

  /// Shows a message of heads() again, as MessageIndex does.
  void show(std::size_t index, const std::function<void(const BagMessage& message)>& see) const {
    index_.read(index, see);
  }

 private:
  std::vector<Head> heads_;
  MessageIndex index_;
};

}  // namespace synthetic_dataset::motion
