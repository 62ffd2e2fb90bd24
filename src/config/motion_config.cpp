#include "config/readers.h"

#include <glob.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "config/checked_values.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::config {
namespace {

constexpr const char* kEntry =
    "it should be a topic's name, or a group such as {topic: /vicon/cup, frame: cup} or {topic: "
    "/joint_states, object: arm}";

/// One entry of `pose_topics`; nullopt if it is wrong, which is noted.
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

/// Reads `tf_topics` and `pose_topics`, which select what is read from a recording.
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

/// Reads `max_tf_gap`; `.inf` allows any gap.
std::optional<double> readLongestGap(Parameters& root) {
  const auto given = root.maybe<Value>("max_tf_gap");
  const double* number = given ? given->as<double>() : nullptr;
  if (number != nullptr && std::isinf(*number) && *number > 0.0) return *number;
  return maybeSeconds(root, "max_tf_gap");
}

/// Whether the camera in `camera`, or any of those in `cameras`, has recorded pictures.
bool hasPictures(Parameters& root) {
  Parameters camera = root.group("camera");
  if (camera.has("image_topic")) return true;
  Parameters cameras = root.group("cameras");
  const std::vector<std::string> names = cameras.names();
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return cameras.maybe<Value>(name)->is<Value::Map>() && cameras.group(name).has("image_topic");
  });
}

/// The files that match a pattern such as `/data/walk_*.bag`, in the order of their names. A name
/// that is not a pattern, or is the name of an existing file, is returned as it is.
std::vector<std::string> matching(const std::string& path) {
  if (path.find_first_of("*?[") == std::string::npos || std::filesystem::exists(path)) {
    return {path};
  }
  glob_t found{};
  std::vector<std::string> files;
  if (glob(path.c_str(), GLOB_NOSORT, nullptr, &found) == 0) {
    files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  }
  globfree(&found);
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> bagsNamed(Parameters& root, const std::vector<std::string>& names) {
  std::vector<std::string> bags;
  for (const std::string& name : names) {
    const std::vector<std::string> files = matching(absolutePath(name));
    if (files.empty()) {
      root.addError("bag_file", "found no bag like '" + name +
                                    "'; it should name a file, or a pattern that matches some");
    }
    bags.insert(bags.end(), files.begin(), files.end());
  }
  return bags;
}

}  // namespace

motion::MotionOptions readMotion(Parameters& root) {
  motion::MotionOptions motion;
  motion.source = choice<motion::MotionSource>(
      root, "motion",
      {{"bag", motion::MotionSource::kBag}, {"placement", motion::MotionSource::kPlacement}});
  const bool is_placed = motion.source == motion::MotionSource::kPlacement;
  if (is_placed) {
    motion.bag_files = root.maybe<std::vector<std::string>>("bag_file").value_or(motion.bag_files);
    if (!root.has("scenes")) (void)root.required<std::int64_t>("scenes");  // reports it
    motion.scenes = maybeSceneCount(root, "scenes").value_or(1);
    refuseWithout(root,
                  {"start_offset", "duration", "max_tf_gap", "stretch", "tf_topics", "pose_topics",
                   "when_unknown"},
                  "motion: bag");
  } else {
    motion.bag_files = root.required<std::vector<std::string>>("bag_file");
    refuseWithout(root, {"scenes", "placement"}, "motion: placement");
  }
  if (isEmptyList(root, "bag_file")) {
    root.addError("bag_file", "found an empty list; it should name at least one bag");
  }
  motion.bag_files = bagsNamed(root, motion.bag_files);
  // Scenes at the times of recorded pictures need no rate.
  if (root.has("simulated_rate") || !hasPictures(root)) {
    motion.rate = numberAbove(root, "simulated_rate", motion.rate, 0.0);
  }
  constexpr double kHighestRate = 1e9;  // a period of one nanosecond
  if (motion.rate > kHighestRate) {
    root.addError("simulated_rate", "found " + Value(motion.rate).text() + " Hz; at most 1e9");
    motion.rate = 30.0;
  }
  if (is_placed) return motion;
  motion.start_offset = maybeSeconds(root, "start_offset").value_or(0.0);
  motion.duration = maybeSeconds(root, "duration");
  motion.max_tf_gap = readLongestGap(root);
  readTopics(root, motion);
  constexpr std::int64_t kLast = 1000000000;
  const auto stretch = root.maybeBetween<std::int64_t>("stretch", 0, kLast);
  if (stretch) motion.stretch = static_cast<std::size_t>(*stretch);
  return motion;
}

}  // namespace synthetic_dataset::config
