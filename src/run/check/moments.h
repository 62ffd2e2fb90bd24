#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "run/setup/motion_setup.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::run {

/// Where a motion's objects are at a time.
struct Moment {
  Stamp stamp{0};
  std::vector<std::optional<Pose>> X_GO;  ///< of all objects; none: it is not there
};

/// Indices evenly spread over a sequence, the first and the last among them.
[[nodiscard]] std::vector<std::size_t> evenlySpread(std::size_t count, std::size_t most);

/// Some hundred times all over a recording, or the placed scenes that were made.
/// @param scenes  that were made of this motion
[[nodiscard]] std::vector<Moment> momentsOf(const MotionSetup& motion,
                                            const std::vector<const Scene*>& scenes);

}  // namespace synthetic_dataset::run
