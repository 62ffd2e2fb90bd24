#include "motion/bag/topic_search.h"

#include <exception>
#include <utility>
#include <vector>

#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::motion {
namespace {

std::string withoutSlash(const std::string& topic) {
  return topic.empty() || topic.front() != '/' ? topic : topic.substr(1);
}

}  // namespace

TopicSearch::TopicSearch(std::string topic, Types types)
    : topic_(std::move(topic)), types_(std::move(types)) {}

void TopicSearch::in(const std::string& file,
                     const std::function<void(BagMessages& messages)>& see) {
  has_bag_ = true;
  const auto bag = openBag(file);
  const std::string name = withoutSlash(topic_);
  std::set<std::string> names;
  for (const BagTopic& topic : bag->topics()) {
    const bool right_type = types_.count(topic.md5sum) != 0;
    if (right_type) topics_.insert(topic.name);
    if (withoutSlash(topic.name) != name) continue;
    if (right_type) {
      names.insert(topic.name);
    } else {
      other_type_ = topic.type + (topic.problem.empty() ? "" : " (" + topic.problem + ")");
    }
  }
  if (names.empty()) return;
  const auto messages =
      bag->messages([&](const std::string& each) { return names.count(each) != 0; });
  try {
    see(*messages);
  } catch (const std::exception& error) {
    throw Error("bag " + file + ": " + error.what());
  }
}

Error TopicSearch::notFound() const {
  if (!has_bag_) {
    return Error("found '" + topic_ + "', a topic of a recording; bag_file should name its bags");
  }
  std::string type;
  for (const auto& [md5sum, name] : types_) type += (type.empty() ? "" : " or ") + name;
  if (!other_type_.empty()) {
    return Error("found '" + topic_ + "', whose messages are " + other_type_ + "; they should be " +
                 type);
  }
  std::string there;
  for (const std::string& topic : topics_) there += (there.empty() ? "" : ", ") + topic;
  return Error("found '" + topic_ + "', a topic that the recording does not have; of type " + type +
               " it has " + (there.empty() ? "none" : there) +
               didYouMean(topic_, {topics_.begin(), topics_.end()}));
}

}  // namespace synthetic_dataset::motion
