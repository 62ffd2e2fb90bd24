#pragma once

#include <vector>

#include "run/check/finding.h"
#include "run/check/named_rays.h"
#include "run/setup/motion_setup.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::run {

/// Finds cameras that are inside something, below the ground or right in front of a wall, or that
/// see only one object.
/// @param rays  of the motion's world
/// @param scenes  of this motion, with visible masks
[[nodiscard]] std::vector<Finding> checkCameras(const MotionSetup& motion, const NamedRays& rays,
                                                const std::vector<const Scene*>& scenes);

/// Finds spot lights that cast shadows and are inside something, so that none of their light gets
/// out.
[[nodiscard]] std::vector<Finding> checkLights(const MotionSetup& motion, const NamedRays& rays,
                                               const std::vector<const Scene*>& scenes);

/// Finds objects that are seen in none of a motion's scenes, or in hardly any, and why.
/// @param rays  of the motion's world
/// @param scenes  of this motion, with silhouettes, visible masks and visibility
[[nodiscard]] std::vector<Finding> checkVisibility(const MotionSetup& motion, const NamedRays& rays,
                                                   const std::vector<const Scene*>& scenes);

}  // namespace synthetic_dataset::run
