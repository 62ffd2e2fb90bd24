#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "base/ros_messages/scene_messages.h"
#include "world/world.h"

namespace synthetic_dataset::programs {

/// The world's surroundings and props at their current poses, in the global frame and the colours
/// of their materials: a marker for each link. The largest are left out if all together have more
/// triangles than RViz draws in time.
/// @param stamp  of the messages
[[nodiscard]] visualization_msgs::MarkerArray worldMarkers(const world::World& world,
                                                           const ros_messages::SceneFrames& frames,
                                                           Stamp stamp);

}  // namespace synthetic_dataset::programs
