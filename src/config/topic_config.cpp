#include "config/topic_config.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::config {
namespace {

constexpr const char* kEntry =
    "it should be a topic's name, or a group such as {topic: /vicon/cup, frame: cup} or {topic: "
    "/joint_states, object: arm}";

/// One entry of `pose_topics`; nothing where it is wrong, which is noted.
std::optional<motion::PoseTopic> poseTopicOf(Parameters& root, const Value& entry) {
  const auto wrong = [&](const std::string& what) {
    root.addError("pose_topics", "found " + what + "; " + kEntry);
    return std::nullopt;
  };
  if (const auto* name = entry.as<std::string>()) {
    if (name->empty()) return wrong("an empty text");
    return motion::PoseTopic{*name, std::nullopt, std::nullopt};
  }
  const auto* group = entry.as<Value::Map>();
  if (group == nullptr) return wrong(entry.kind());
  motion::PoseTopic topic;
  for (const auto& [name, value] : *group) {
    const auto* text = value.as<std::string>();
    const bool is_known = name == "topic" || name == "frame" || name == "object";
    if (!is_known) return wrong("'" + name + "'" + didYouMean(name, {"topic", "frame", "object"}));
    if (text == nullptr || text->empty()) return wrong(name + ": " + value.text());
    if (name == "topic") topic.topic = *text;
    if (name == "frame") topic.frame = *text;
    if (name == "object") topic.object = *text;
  }
  if (topic.topic.empty()) return wrong("a group without `topic`");
  if (topic.frame && topic.object) return wrong("both `frame` and `object`");
  return topic;
}

}  // namespace

void readTopics(Parameters& root, motion::MotionOptions& motion) {
  motion.tf_topics =
      root.maybe<std::vector<std::string>>("tf_topics").value_or(std::vector<std::string>{});
  const auto given = root.maybe<Value>("pose_topics");
  if (!given) return;
  Value::List entries;
  if (const auto* list = given->as<Value::List>()) {
    entries = *list;
  } else {
    entries.push_back(*given);
  }
  std::set<std::string> seen;
  for (const Value& entry : entries) {
    const auto topic = poseTopicOf(root, entry);
    if (!topic) continue;
    if (!seen.insert(topic->topic).second) {
      root.addError("pose_topics", "found '" + topic->topic + "' more than once");
      continue;
    }
    motion.pose_topics.push_back(*topic);
  }
}

}  // namespace synthetic_dataset::config
