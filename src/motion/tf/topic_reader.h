#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include <geometry_msgs/TransformStamped.h>
#include <rosbag/message_instance.h>

#include "motion/tf/left_out_transforms.h"

namespace synthetic_dataset::motion {

/// How the messages of a topic become transforms.
struct TopicReader {
  TransformKind kind = TransformKind::kMoving;
  std::function<std::vector<geometry_msgs::TransformStamped>(const rosbag::MessageInstance&)> read;
};

/// By topic, as the bags spell it.
using TopicReaders = std::map<std::string, TopicReader>;

}  // namespace synthetic_dataset::motion
