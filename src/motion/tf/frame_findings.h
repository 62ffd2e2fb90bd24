#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "motion/frame_names.h"
#include "motion/tf/link_history.h"

namespace synthetic_dataset::motion {

/// Something odd about one frame of a recording, for the user.
struct FrameFinding {
  FrameId child;
  std::string message;
};

/// Whether two transforms are the same except for rounding.
[[nodiscard]] bool isSameTransform(const geometry_msgs::Transform& a,
                                   const geometry_msgs::Transform& b);

/// Finds a frame that jumps back and forth between two positions, or two parents, as if two
/// publishers moved it.
/// @param samples  ascending by stamp
/// @param publishers  that sent them, as far as known
[[nodiscard]] std::optional<FrameFinding> findFight(const FrameNames& names, FrameId child,
                                                    const std::vector<LinkHistory::Sample>& samples,
                                                    const std::vector<std::string>& publishers);

/// Finds a frame whose parent changes.
[[nodiscard]] std::optional<FrameFinding> findParentChange(
    const FrameNames& names, FrameId child, const std::vector<LinkHistory::Sample>& samples);

/// Finds a static transform with several values.
/// @param samples  its values, in the order of the times from which they hold
/// @param is_moved  whether `/tf` contains the frame as well
[[nodiscard]] std::optional<FrameFinding> findStaticChange(
    const FrameNames& names, FrameId child, const std::vector<LinkHistory::Sample>& samples,
    bool is_moved);

}  // namespace synthetic_dataset::motion
