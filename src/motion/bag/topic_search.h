#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>

#include "motion/bag/bag.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {

/// Looks for a topic's messages in one bag after another, and remembers similar topics in case
/// there are none.
class TopicSearch {
 public:
  /// Makes a search for messages of one of these types.
  /// @param topic  with or without a leading slash
  template <class... Messages>
  [[nodiscard]] static TopicSearch of(const std::string& topic) {
    return {topic,
            {{ros::message_traits::MD5Sum<Messages>::value(),
              ros::message_traits::DataType<Messages>::value()}...}};
  }

  /// Passes a bag's messages of the topic to `see`, in the order of their record times; does
  /// nothing if there are none.
  /// @param see  what it throws is rethrown as an Error that names the bag
  /// @throws Error naming the bag, if it cannot be read
  void in(const std::string& file, const std::function<void(BagMessages& messages)>& see);

  /// The error if none of the bags has the topic: lists the topics of the right types.
  [[nodiscard]] Error notFound() const;

 private:
  using Types = std::map<std::string, std::string>;  ///< names by their checksums

  TopicSearch(std::string topic, Types types);

  std::string topic_;
  Types types_;
  bool has_bag_ = false;          ///< whether any bag was searched
  std::set<std::string> topics_;  ///< that are of the right types
  std::string other_type_;        ///< the topic's type, if it is not a wanted one
};

}  // namespace synthetic_dataset::motion
