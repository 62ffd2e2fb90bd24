#include "motion/tf/tf_topics.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "base/name_list.h"
#include "motion/bag/checked_messages.h"
#include "motion/frame_names.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::motion {
namespace {

std::string withSlash(const std::string& topic) {
  return topic.empty() || topic.front() == '/' ? topic : "/" + topic;
}

struct Parts {
  std::string space;  ///< "/robot1", or empty
  std::string name;   ///< "tf"
};

Parts partsOf(const std::string& topic) {
  const std::string whole = withSlash(topic);
  const std::size_t slash = whole.rfind('/');
  return {whole.substr(0, slash), whole.substr(slash + 1)};
}

bool isStatic(const std::string& topic) {
  static const std::string kEnd = "tf_static";
  return topic.size() >= kEnd.size() &&
         topic.compare(topic.size() - kEnd.size(), kEnd.size(), kEnd) == 0;
}

bool isNamedTf(const std::string& topic) {
  const std::string name = partsOf(topic).name;
  return name == "tf" || name == "tf_static";
}

std::vector<geometry_msgs::TransformStamped> transformsOf(const BagMessage& message) {
  const auto recorded = message.instantiate<RecordedTransforms>();
  return std::move(recorded->message.transforms);
}

using Traits = ros::message_traits::MD5Sum<tf2_msgs::TFMessage>;

/// By the checksum, as in librosbag: tf/tfMessage of tf version 1 has the same content.
bool hasTransforms(const BagTopic& topic) { return topic.md5sum == Traits::value(); }

void add(const std::string& topic, TopicReaders& readers) {
  readers[topic] = {isStatic(topic) ? TransformKind::kStatic : TransformKind::kMoving,
                    transformsOf};
}

/// All topics of TF's type.
std::vector<std::string> topicsOfTf(const BagReader& bags) {
  std::vector<std::string> topics;
  for (const BagTopic& topic : bags.topics()) {
    if (hasTransforms(topic)) topics.push_back(topic.name);
  }
  return topics;
}

TopicReaders namedTopics(const BagReader& bags, const std::vector<std::string>& named) {
  TopicReaders readers;
  std::vector<std::string> errors;
  const std::vector<std::string> all = topicsOfTf(bags);
  for (const std::string& name : named) {
    std::size_t found = 0;
    for (const std::string& topic : all) {
      if (withSlash(topic) != withSlash(name)) continue;
      add(topic, readers);
      ++found;
    }
    if (found > 0) continue;
    errors.push_back("tf_topics: found '" + name + "', a topic of TF that the recording does not " +
                     "have; it has " + (all.empty() ? "none" : base::listed(all)) +
                     didYouMean(name, all));
  }
  if (!errors.empty()) throw ErrorList(errors);
  return readers;
}

/// Readers of /tf and /tf_static without a namespace.
TopicReaders usualTopics(const BagReader& bags) {
  TopicReaders readers;
  std::vector<std::string> errors;
  for (const auto& bag : bags.bags()) {
    for (const BagTopic& topic : bag->topics()) {
      if (!isNamedTf(topic.name) || !partsOf(topic.name).space.empty()) continue;
      add(topic.name, readers);
      if (hasTransforms(topic)) continue;
      if (!topic.problem.empty()) {
        errors.push_back("bag " + bag->file() + ": topic " + topic.name + " (" + topic.type +
                         ") cannot be read: " + topic.problem);
        continue;
      }
      errors.push_back("bag " + bag->file() + ": topic " + topic.name + " has messages of type " +
                       topic.type + " (md5sum " + topic.md5sum + "); tf2_msgs/TFMessage (md5sum " +
                       Traits::value() + ") is needed");
    }
  }
  if (!errors.empty()) throw ErrorList(errors);
  return readers;
}

bool anyMoves(const TopicReaders& readers) {
  return std::any_of(readers.begin(), readers.end(),
                     [](const auto& each) { return each.second.kind == TransformKind::kMoving; });
}

/// Adds the topics of the only namespace that has TF; returns a note for the user.
std::string addNamespace(const BagReader& bags, TopicReaders& readers) {
  std::map<std::string, std::vector<std::string>> spaces;
  for (const std::string& topic : topicsOfTf(bags)) {
    const Parts parts = partsOf(topic);
    if (isNamedTf(topic) && !parts.space.empty()) spaces[parts.space].push_back(topic);
  }
  if (spaces.empty()) return "";
  if (spaces.size() > 1) {
    if (!readers.empty()) return "";
    std::string list;
    for (const auto& [space, topics] : spaces)
      list += (list.empty() ? "" : ", ") + base::listed(topics);
    throw ErrorList({"tf_topics: the recording has no /tf, and TF of several namespaces: " + list +
                     "; tf_topics should list those to read: tf_topics: [" +
                     base::listed(spaces.begin()->second) + "]"});
  }
  for (const std::string& topic : spaces.begin()->second) add(topic, readers);
  return "TF is taken from " + base::listed(spaces.begin()->second) +
         ", as the recording has no /tf and no other namespace has TF";
}

}  // namespace

TfTopics findTfTopics(const BagReader& bags, const std::vector<std::string>& named) {
  TfTopics found;
  found.readers = named.empty() ? usualTopics(bags) : namedTopics(bags, named);
  if (named.empty() && !anyMoves(found.readers)) found.note = addNamespace(bags, found.readers);
  for (const std::string& topic : topicsOfTf(bags)) {
    if (found.readers.count(topic) == 0) found.ignored.push_back(topic);
  }
  return found;
}

std::vector<std::string> noTransforms(const BagReader& bags) {
  std::vector<std::string> messages;
  for (const auto& bag : bags.bags()) {
    std::string topics;
    for (const BagTopic& topic : bag->topics()) {
      topics += (topics.empty() ? "" : ", ") + topic.name + " (" + topic.type + ")";
    }
    messages.push_back("bag " + bag->file() + ": " +
                       (bag->times() ? "no messages of /tf or /tf_static; its topics are " + topics
                                     : std::string("has no messages")));
  }
  return messages;
}

}  // namespace synthetic_dataset::motion
