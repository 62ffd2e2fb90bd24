#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "run/setup/motion_setup.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::run {

/// The poses of a motion's objects at one time.
struct Moment {
  Stamp stamp{0};
  std::vector<std::optional<Pose>> X_GO;  ///< of all objects; nothing for an absent one
};

/// Indices evenly spread over a sequence, including the first and the last.
[[nodiscard]] std::vector<std::size_t> evenlySpread(std::size_t count, std::size_t most);

/// Some hundred times spread over a recording, or those of the placed scenes that were made.
/// @param scenes  made of this motion
[[nodiscard]] std::vector<Moment> momentsOf(const MotionSetup& motion,
                                            const std::vector<const Scene*>& scenes);

}  // namespace synthetic_dataset::run
