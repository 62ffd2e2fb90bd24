#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>

#include "motion/bag/bag.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {

/// Looks for a topic's messages in one bag after another, and remembers what there is instead.
class TopicSearch {
 public:
  /// For messages of one of these types.
  /// @param topic  with or without a leading slash
  template <class... Messages>
  [[nodiscard]] static TopicSearch of(const std::string& topic) {
    return {topic,
            {{ros::message_traits::MD5Sum<Messages>::value(),
              ros::message_traits::DataType<Messages>::value()}...}};
  }

  /// Shows a bag's messages of the topic, in the order of their times; nothing when it has none.
  /// @param see  what it throws is an Error that names the bag
  /// @throws Error naming the bag when it cannot be read
  void in(const std::string& file, const std::function<void(BagMessages& messages)>& see);

  /// What to say when none of the bags had it: with the topics of the type that there are.
  [[nodiscard]] Error notFound() const;

 private:
  using Types = std::map<std::string, std::string>;  ///< names by their checksums

  TopicSearch(std::string topic, Types types);

  std::string topic_;
  Types types_;
  bool has_bag_ = false;          ///< whether there was any to look in
  std::set<std::string> topics_;  ///< that are of the types
  std::string other_type_;        ///< that of the topic, where it is not the one that was wanted
};

}  // namespace synthetic_dataset::motion
