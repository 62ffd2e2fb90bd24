#pragma once

#include <vector>

#include <visualization_msgs/MarkerArray.h>

#include "base/ros_messages/scene_messages.h"
#include "run/setup/motion_setup.h"
#include "synthetic_dataset/scene.h"

/// The markers of a preview for RViz, in the global frame.
namespace synthetic_dataset::programs {

/// Each labelled object's box and name, its keypoints (green if they are seen) and its bounding
/// shape's points; the first marker deletes what was shown before.
/// @param scene  with visibility or visible masks, and with keypoint states
[[nodiscard]] visualization_msgs::MarkerArray labelMarkers(const Scene& scene,
                                                           const ros_messages::SceneFrames& frames);

/// The edges of a camera's field of view, up to a metre from it.
[[nodiscard]] visualization_msgs::Marker viewMarker(const Scene& scene,
                                                    const ros_messages::SceneFrames& frames);

/// The points that lidars measure, in the global frame: those of objects in the colours of their
/// boxes, those of the world in a darker colour for their class, or grey without one.
/// @param scene  with clouds
[[nodiscard]] visualization_msgs::MarkerArray cloudMarkers(const Scene& scene,
                                                           const ros_messages::SceneFrames& frames);

/// The paths of a recording's objects, a line each. Placed scenes have none.
/// @param stamp  of the messages
[[nodiscard]] visualization_msgs::MarkerArray wayMarkers(const run::MotionSetup& motion,
                                                         const ros_messages::SceneFrames& frames,
                                                         Stamp stamp);

}  // namespace synthetic_dataset::programs
