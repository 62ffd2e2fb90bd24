#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "synthetic_dataset/parameters.h"
#include "synthetic_dataset/pose.h"

/// How poses are written: in seven numbers, or by a position and angles.
namespace synthetic_dataset::config {

/// Three numbers, none beyond `farthest`; nothing where they are not there or wrong, which is
/// noted.
/// @param should  what they should be, for the message
[[nodiscard]] std::optional<Eigen::Vector3d> maybeVector(Parameters& group, const std::string& name,
                                                         double farthest,
                                                         const std::string& should);

/// `rpy: [roll, pitch, yaw]`, in radians.
[[nodiscard]] std::optional<Eigen::Vector3d> maybeAngles(Parameters& group);

/// `[x, y, z, qx, qy, qz, qw]`. A wrong one is noted, and becomes a harmless pose: without any,
/// there would be a second error.
/// @param or_else  what it may be instead, for the message
[[nodiscard]] Pose readPose(Parameters& group, const std::string& name,
                            const std::string& or_else = "");

}  // namespace synthetic_dataset::config
