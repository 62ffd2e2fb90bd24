#pragma once

#include <ros/node_handle.h>

#include "run/reporter.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// Whether settings, or those of one of their `motions`, ask for a map from the running system:
/// `placement/map_topic` without `bag_file`.
[[nodiscard]] bool wantsTopicMap(const Value& settings);

/// Waits for each such map and adds it as `placement/received_map`.
/// @param settings  ones that ask for a map
/// @param node  subscribes for as long as it takes
/// @param reporter  is told what is waited for
/// @throws Error when no map arrives, with what there is instead
void takeTopicMap(Value& settings, ros::NodeHandle& node, run::Reporter& reporter);

}  // namespace synthetic_dataset::programs
