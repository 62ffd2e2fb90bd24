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

/// The direction from which an object is viewed, and the picture's width.
struct Viewpoint {
  double yaw = 0.6;     ///< about the object's z; 0 views from its +x side [rad]
  double pitch = 0.35;  ///< above its xy plane [rad]
  int width = 640;      ///< [px]; the height is three quarters of it
};

/// A keypoint on a portrait.
struct PortraitPoint {
  Eigen::Vector2d pixel{0, 0};
  bool is_visible = false;  ///< not hidden by the object itself
};

/// A picture of nothing but an object.
struct ObjectPortrait {
  cv::Mat picture;                       ///< CV_8UC3
  std::vector<PortraitPoint> keypoints;  ///< in the order of the settings
  Cuboid box_O;                          ///< around everything visible of it
};

/// A point on an object's surface.
struct PickedPoint {
  std::string link;
  Eigen::Vector3d p_O{0, 0, 0};  ///< in the frame used for keypoints [m]
};

/// @param motion  must have its world
/// @param object  its index
/// @throws Error if nothing of it is visible
[[nodiscard]] ObjectPortrait portrayObject(const MotionSetup& motion, std::size_t object,
                                           const Viewpoint& viewpoint);

/// The point shown by a pixel of the object's portrait; nothing if the pixel misses the object.
[[nodiscard]] std::optional<PickedPoint> pickPoint(const MotionSetup& motion, std::size_t object,
                                                   const Viewpoint& viewpoint,
                                                   const Eigen::Vector2d& pixel);

/// Without the picture, for programs.
[[nodiscard]] Value::Map portraitValue(const ObjectPortrait& portrait);

}  // namespace synthetic_dataset::run
