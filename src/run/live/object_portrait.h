#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "run/setup/motion_setup.h"
#include "synthetic_dataset/cuboid.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// From where an object is looked at, and how wide the picture is.
struct Viewpoint {
  double yaw = 0.6;     ///< about the object's z, 0 from where its x points [rad]
  double pitch = 0.35;  ///< above its x and y [rad]
  int width = 640;      ///< [px]; the height is three quarters of it
};

/// A keypoint on a portrait.
struct PortraitPoint {
  Eigen::Vector2d pixel{0, 0};
  bool is_visible = false;  ///< nothing of the object is before it
};

/// A picture of an object alone.
struct ObjectPortrait {
  cv::Mat picture;                       ///< CV_8UC3
  std::vector<PortraitPoint> keypoints;  ///< as the settings have them
  Cuboid box_O;                          ///< around all that is seen of it
};

/// A point on an object's surface.
struct PickedPoint {
  std::string link;
  Eigen::Vector3d p_O{0, 0, 0};  ///< in the frame in which keypoints are written [m]
};

/// @param motion  with its world
/// @param object  its index
/// @throws Error where there is nothing to see of it
[[nodiscard]] ObjectPortrait portrayObject(const MotionSetup& motion, std::size_t object,
                                           const Viewpoint& viewpoint);

/// What a pixel of the object's portrait shows; nothing beside the object.
[[nodiscard]] std::optional<PickedPoint> pickPoint(const MotionSetup& motion, std::size_t object,
                                                   const Viewpoint& viewpoint,
                                                   const Eigen::Vector2d& pixel);

/// Without the picture, for programs.
[[nodiscard]] Value::Map portraitValue(const ObjectPortrait& portrait);

}  // namespace synthetic_dataset::run
