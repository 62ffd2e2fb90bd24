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

/// An index of a topic's messages in bags that count as one recording, by the stamps in the
/// messages' headers.
class MessageIndex {
 public:
  /// Looks at a message, and returns its stamp.
  using Look = std::function<Stamp(const BagMessage& message)>;

  /// Looks at all messages of the topic, in the order in which they were recorded.
  /// @param bag_files  bags that can be read
  /// @param noun  what a message contains, for messages to the user: "picture"
  /// @throws Error if no bag has such a topic, its messages are of another type or have no stamps,
  ///     or their stamps go back in time
  MessageIndex(const std::vector<std::string>& bag_files, const std::string& topic,
               const std::string& noun, TopicSearch search, const Look& look);
  ~MessageIndex();
  MessageIndex(MessageIndex&&) noexcept;
  MessageIndex& operator=(MessageIndex&&) noexcept;

  /// The number of messages left out because they have the stamp of another one.
  [[nodiscard]] std::int64_t repeatedCount() const;

  /// Sorts what was noted about each message into the order of this index: by stamp, with only the
  /// first recorded message of equal stamps.
  template <class Noted>
  [[nodiscard]] std::vector<Noted> inOrder(std::vector<Noted> looked_at) const {
    std::vector<Noted> ordered;
    for (const std::size_t index : order()) ordered.push_back(std::move(looked_at[index]));
    return ordered;
  }

  /// Reads a message again and passes it to `see`. May be called in any thread.
  /// @throws Error naming the bag, if it cannot be read any more
  void read(std::size_t index, const std::function<void(const BagMessage& message)>& see) const;

 private:
  /// For each message of the index, its number among those that were looked at.
  [[nodiscard]] const std::vector<std::size_t>& order() const;

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The messages of a topic, with a summary of each instead of its content.
/// @tparam Head  the summary; has the message's `stamp`
template <class Head>
class RecordedMessages {
 public:
  /// All messages in the order of their stamps, only the first recorded one of equal stamps; at
  /// least one.
  [[nodiscard]] const std::vector<Head>& heads() const { return heads_; }

  /// The number of messages left out because they have the stamp of another one.
  [[nodiscard]] std::int64_t repeatedCount() const { return index_.repeatedCount(); }

 protected:
  /// @param head_of  makes a message's summary; the other parameters are those of MessageIndex
  RecordedMessages(const std::vector<std::string>& bag_files, const std::string& topic,
                   const std::string& noun, TopicSearch search,
                   const std::function<Head(const BagMessage& message)>& head_of)
      : index_(bag_files, topic, noun, std::move(search), [&](const BagMessage& message) {
          heads_.push_back(head_of(message));
          return heads_.back().stamp;
        }) {
    heads_ = index_.inOrder(std::move(heads_));
  }

  /// Reads a message of heads() again, see MessageIndex::read().
  void show(std::size_t index, const std::function<void(const BagMessage& message)>& see) const {
    index_.read(index, see);
  }

 private:
  std::vector<Head> heads_;
  MessageIndex index_;
};

}  // namespace synthetic_dataset::motion
