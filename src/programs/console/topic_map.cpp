#include "programs/console/topic_map.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <nav_msgs/OccupancyGrid.h>
#include <ros/callback_queue.h>
#include <ros/master.h>
#include <ros/this_node.h>

#include "config/motion_list.h"
#include "motion/recorded/recorded_map.h"
#include "randomize/placement/received_map.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::programs {
namespace {

constexpr double kTimeout = 10.0;  // [s]
const char* const kType = "nav_msgs/OccupancyGrid";

const Value* entryIn(const Value* group, const std::string& name) {
  const auto* map = group == nullptr ? nullptr : group->as<Value::Map>();
  const auto found = map == nullptr ? Value::Map::const_iterator{} : map->find(name);
  return map == nullptr || found == map->end() ? nullptr : &found->second;
}

std::string textIn(const Value* group, const std::string& name) {
  const Value* value = entryIn(group, name);
  const auto* text = value == nullptr ? nullptr : value->as<std::string>();
  return text == nullptr ? "" : *text;
}

bool namesBags(const Value* files) {
  if (files == nullptr) return false;
  const auto* list = files->as<Value::List>();
  const auto* text = files->as<std::string>();
  return list != nullptr ? !list->empty() : text == nullptr || !text->empty();
}

/// The topic from which a map is wanted; empty if none is, or if something is wrong, which is
/// reported with all other errors.
std::string wantedTopic(const Value& settings) {
  const Value* placement = entryIn(&settings, "placement");
  const std::string mode = textIn(placement, "mode");
  const bool has_map =
      entryIn(placement, "map") != nullptr || entryIn(placement, "received_map") != nullptr;
  if (textIn(&settings, "motion") != "placement" || has_map) return "";
  if (!(mode.empty() || mode == "map") || namesBags(entryIn(&settings, "bag_file"))) return "";
  return textIn(placement, "map_topic");
}

/// The nodes that publish a topic.
std::string publishersOf(const std::string& topic) {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue state;
  request[0] = ros::this_node::getName();
  if (!ros::master::execute("getSystemState", request, response, state, false)) return "";
  std::string nodes;
  XmlRpc::XmlRpcValue& published = state[0];
  for (int i = 0; i < published.size(); ++i) {
    if (static_cast<std::string>(published[i][0]) != topic) continue;
    for (int j = 0; j < published[i][1].size(); ++j) {
      nodes += (nodes.empty() ? "" : ", ") + static_cast<std::string>(published[i][1][j]);
    }
  }
  return nodes;
}

/// What the master knows about topics.
struct Topics {
  std::string type;            ///< of the wanted topic; empty: nobody publishes it
  std::set<std::string> maps;  ///< the topics of the right type
};

Topics askMaster(const std::string& topic) {
  ros::master::V_TopicInfo all;
  ros::master::getTopics(all);
  Topics topics;
  for (const ros::master::TopicInfo& each : all) {
    if (each.name == topic) topics.type = each.datatype;
    if (each.datatype == kType) topics.maps.insert(each.name);
  }
  return topics;
}

void checkType(const std::string& topic, const Topics& topics) {
  if (topics.type.empty() || topics.type == "*" || topics.type == kType) return;
  throw Error("found '" + topic + "', which " + publishersOf(topic) + " publishes as " +
              topics.type + "; it should be " + kType);
}

Error noMap(const std::string& topic) {
  const Topics topics = askMaster(topic);
  const std::string found =
      "found '" + topic + "', on which no map came within " + fixed(kTimeout, 0) + " s: ";
  if (!topics.type.empty()) {
    return Error(found + publishersOf(topic) +
                 " publishes it, but sent none; it should be latched, as map_server's is");
  }
  std::string maps;
  for (const std::string& each : topics.maps) maps += (maps.empty() ? "" : ", ") + each;
  return Error(found + "nobody publishes it; of type " + kType + " there is " +
               (maps.empty() ? "none" : maps) +
               didYouMean(topic, {topics.maps.begin(), topics.maps.end()}) +
               "; map_server or the like should run, bag_file should name a bag with the topic, or "
               "placement/map map_server's YAML file");
}

nav_msgs::OccupancyGrid waitFor(const std::string& topic, ros::NodeHandle& node) {
  checkType(topic, askMaster(topic));
  ros::CallbackQueue queue;
  nav_msgs::OccupancyGrid::ConstPtr map;
  auto options = ros::SubscribeOptions::create<nav_msgs::OccupancyGrid>(
      topic, 1, [&](const nav_msgs::OccupancyGrid::ConstPtr& message) { map = message; }, {},
      &queue);
  const ros::Subscriber subscriber = node.subscribe(options);
  // Wall-clock time: a simulation's clock may stand still.
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kTimeout);
  while (!map && ros::ok() && ros::WallTime::now() < end) {
    queue.callAvailable(ros::WallDuration(0.1));
    checkType(topic, askMaster(topic));
  }
  if (!map) throw noMap(topic);
  return *map;
}

/// The group `placement` of a motion's own settings, or of the run's if the motion has none.
Value::Map& placementOf(Value& settings, const config::MotionEntry& motion) {
  Value::Map* group = settings.as<Value::Map>();
  if (!motion.group.empty()) {
    auto& entries = *group->at("motions").as<Value::List>();
    const std::size_t index = std::stoul(motion.group.substr(motion.group.find('/') + 1));
    Value::Map* own = entries.at(index).as<Value::Map>();
    if (own->count("placement") != 0) group = own;
  }
  return *group->at("placement").as<Value::Map>();
}

}  // namespace

bool wantsTopicMap(const Value& settings) {
  const config::MotionList motions = config::readMotions(settings);
  return std::any_of(motions.entries.begin(), motions.entries.end(),
                     [](const auto& motion) { return !wantedTopic(motion.settings).empty(); });
}

void takeTopicMap(Value& settings, ros::NodeHandle& node, run::Reporter& reporter) {
  std::map<std::string, Value> maps;  // by topic
  const config::MotionList motions = config::readMotions(settings);
  for (std::size_t i = 0; i < motions.entries.size(); ++i) {
    const config::MotionEntry& motion = motions.entries[i];
    const std::string wanted = wantedTopic(motion.settings);
    if (wanted.empty()) continue;
    try {
      const std::string topic = node.resolveName(wanted);
      if (maps.count(topic) == 0) {
        reporter.info("waiting for a map on '" + topic + "', " + fixed(kTimeout, 0) + " s at most");
        maps[topic] = randomize::settingsOf(motion::mapOf(waitFor(topic, node)));
      }
      placementOf(settings, motion)["received_map"] = maps[topic];
    } catch (const std::exception& error) {
      throw Error((motion.group.empty() ? "" : motion.group + ": ") +
                  "placement/map_topic: " + error.what());
    }
  }
}

}  // namespace synthetic_dataset::programs
