#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "synthetic_dataset/parameters.h"
#include "synthetic_dataset/pose.h"

/// Reads poses, which are written as seven numbers, or as a position and angles.
namespace synthetic_dataset::config {

/// Three numbers, none beyond `farthest`; nullopt if they are missing or wrong; the latter is
/// noted.
/// @param should  what they should be, for the message
[[nodiscard]] std::optional<Eigen::Vector3d> maybeVector(Parameters& group, const std::string& name,
                                                         double farthest,
                                                         const std::string& should);

/// `rpy: [roll, pitch, yaw]`, in radians.
[[nodiscard]] std::optional<Eigen::Vector3d> maybeAngles(Parameters& group);

/// `[x, y, z, qx, qy, qz, qw]`. A wrong one is noted and becomes a harmless pose, as a missing one
/// would cause a second error.
/// @param or_else  what it may be instead, for the message
[[nodiscard]] Pose readPose(Parameters& group, const std::string& name,
                            const std::string& or_else = "");

}  // namespace synthetic_dataset::config
