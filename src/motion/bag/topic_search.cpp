#include "motion/bag/topic_search.h"

#include <exception>
#include <utility>
#include <vector>

#include <rosbag/bag.h>

#include "motion/bag/bag_check.h"
#include "motion/bag/ros2_bag.h"
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
                     const std::function<void(rosbag::View& messages)>& see) {
  has_bag_ = true;
  if (isRos2Bag(file)) throw Error("bag " + file + ": " + convertAdvice(file));
  try {
    show(file, see);
  } catch (const std::exception& error) {
    throw Error("bag " + file + ": " + error.what());
  }
}

void TopicSearch::show(const std::string& file,
                       const std::function<void(rosbag::View& messages)>& see) {
  const std::string name = withoutSlash(topic_);
  static_cast<void>(
      checkBag(file, [&](const std::string& other) { return withoutSlash(other) == name; }));
  rosbag::Bag bag(file);
  rosbag::View all(bag);
  std::vector<std::string> names;
  for (const rosbag::ConnectionInfo* connection : all.getConnections()) {
    const bool right_type = types_.count(connection->md5sum) != 0;
    if (right_type) topics_.insert(connection->topic);
    if (withoutSlash(connection->topic) != name) continue;
    if (right_type) {
      names.push_back(connection->topic);
    } else {
      other_type_ = connection->datatype;
    }
  }
  if (names.empty()) return;
  rosbag::View messages(bag, rosbag::TopicQuery(names));
  see(messages);
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
