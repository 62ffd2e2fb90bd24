#pragma once

#include <array>

#include "plugins/readback/drawn_label.h"
#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/pose.h"

/// Draws lines given in a pinhole camera's frame, in any unit of length.
namespace synthetic_dataset::formats {

/// Adds a line between two points, or the part of it that is in front of the camera.
void addLine(DrawnLabel& label, const Intrinsics& camera, const Eigen::Vector3d& a_C,
             const Eigen::Vector3d& b_C);

/// Adds the edges of a box.
/// @param corners_C  in the order of Cuboid::corners()
void addCuboid(DrawnLabel& label, const Intrinsics& camera,
               const std::array<Eigen::Vector3d, 8>& corners_C);

/// Adds the three axes of a frame.
void addAxes(DrawnLabel& label, const Intrinsics& camera, const Pose& X_CO, double length);

}  // namespace synthetic_dataset::formats
