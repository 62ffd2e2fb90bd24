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

/// Whether two transforms are the same, but for rounding.
[[nodiscard]] bool isSameTransform(const geometry_msgs::Transform& a,
                                   const geometry_msgs::Transform& b);

/// A frame that jumps to and fro between two places, or two parents, as one does that two
/// publishers move.
/// @param samples  ascending by stamp
/// @param publishers  that sent them, as far as they are known
[[nodiscard]] std::optional<FrameFinding> findFight(const FrameNames& names, FrameId child,
                                                    const std::vector<LinkHistory::Sample>& samples,
                                                    const std::vector<std::string>& publishers);

/// A frame that hangs below another parent from some time on.
[[nodiscard]] std::optional<FrameFinding> findParentChange(
    const FrameNames& names, FrameId child, const std::vector<LinkHistory::Sample>& samples);

/// A static transform with several values.
/// @param samples  its values, by the time from which each holds
/// @param is_moved  whether `/tf` has the frame as well
[[nodiscard]] std::optional<FrameFinding> findStaticChange(
    const FrameNames& names, FrameId child, const std::vector<LinkHistory::Sample>& samples,
    bool is_moved);

}  // namespace synthetic_dataset::motion
