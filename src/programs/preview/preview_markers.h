#pragma once

#include <vector>

#include <visualization_msgs/MarkerArray.h>

#include "base/ros_messages/scene_messages.h"
#include "run/setup/motion_setup.h"
#include "synthetic_dataset/scene.h"

/// What RViz shows of a preview, in the global frame.
namespace synthetic_dataset::programs {

/// Each labelled object's box and name, its keypoints (green where they are seen) and its
/// bounding shape's points; what was shown before goes first.
/// @param scene  with visibility or visible masks, and with keypoint states
[[nodiscard]] visualization_msgs::MarkerArray labelMarkers(const Scene& scene,
                                                           const ros_messages::SceneFrames& frames);

/// The edges of what a camera sees, up to a metre from it.
[[nodiscard]] visualization_msgs::Marker viewMarker(const Scene& scene,
                                                    const ros_messages::SceneFrames& frames);

/// What lidars measure, in the global frame: points of objects in the colours of their boxes,
/// others darker, by their class of the world, or grey.
/// @param scene  with clouds
[[nodiscard]] visualization_msgs::MarkerArray cloudMarkers(const Scene& scene,
                                                           const ros_messages::SceneFrames& frames);

/// Where the objects of a recording go: a line each. Of placed scenes there are none.
/// @param stamp  of the messages
[[nodiscard]] visualization_msgs::MarkerArray wayMarkers(const run::MotionSetup& motion,
                                                         const ros_messages::SceneFrames& frames,
                                                         Stamp stamp);

}  // namespace synthetic_dataset::programs
