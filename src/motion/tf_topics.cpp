#include "motion/tf_topics.h"

#include <optional>
#include <utility>
#include <vector>

#include "motion/checked_messages.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

/// The topic as a bag may have it, with or without the slash.
std::optional<TransformKind> kindOf(const std::string& topic) {
  if (topic == "/tf" || topic == "tf") return TransformKind::kMoving;
  if (topic == "/tf_static" || topic == "tf_static") return TransformKind::kStatic;
  return std::nullopt;
}

std::vector<geometry_msgs::TransformStamped> transformsOf(const rosbag::MessageInstance& message) {
  const auto recorded = message.instantiate<RecordedTransforms>();
  return std::move(recorded->message.transforms);
}

/// By its checksum, as librosbag does: tf/tfMessage of tf version 1 has the same content.
void checkType(const BagTopic& topic, const std::string& bag) {
  using Traits = ros::message_traits::MD5Sum<tf2_msgs::TFMessage>;
  if (topic.md5sum == Traits::value()) return;
  throw Error("bag " + bag + ": topic " + topic.name + " has messages of type " + topic.type +
              " (md5sum " + topic.md5sum + "); tf2_msgs/TFMessage (md5sum " + Traits::value() +
              ") is needed");
}

std::string listOf(const std::vector<BagTopic>& topics) {
  std::string list;
  for (const BagTopic& topic : topics) {
    list += (list.empty() ? "" : ", ") + topic.name + " (" + topic.type + ")";
  }
  return list;
}

}  // namespace

TopicReaders tfReaders(const BagReader& bags) {
  TopicReaders readers;
  std::vector<std::string> errors;
  std::vector<std::string> without;
  for (const auto& bag : bags.bags()) {
    for (const BagTopic& topic : bag->topics()) {
      const auto kind = kindOf(topic.name);
      if (!kind) continue;
      try {
        checkType(topic, bag->file());
        readers[topic.name] = {*kind, transformsOf};
      } catch (const Error& error) {
        errors.emplace_back(error.what());
      }
    }
    without.push_back(
        "bag " + bag->file() + ": " +
        (bag->times() ? "no messages of /tf or /tf_static; its topics are " + listOf(bag->topics())
                      : std::string("has no messages")));
  }
  if (!errors.empty()) throw ErrorList(errors);
  // Bags without transforms are fine beside one that has some.
  if (readers.empty()) throw ErrorList(without);
  return readers;
}

}  // namespace synthetic_dataset::motion
