#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "base/diagnostics.h"
#include "motion/tf/frame_tree.h"
#include "motion/timeline.h"

namespace synthetic_dataset::motion {

/// The longest gap in a frame's transforms that is not a hole: the larger of 10 s and 20 median
/// periods.
[[nodiscard]] Duration longestGapOf(const LinkHistory& link);

/// Long gaps in a recording, and the scenes that fall into them.
class Holes {
 public:
  /// @param tree, options  have to outlive this
  Holes(const FrameTree& tree, const TimelineOptions& options) : tree_(tree), options_(options) {}

  /// Whether no scene may be made then, as poses would be interpolated across a hole. Where the
  /// pose is the same at both ends, it may. Counts the scene.
  /// @param links  that are crossed for it
  [[nodiscard]] bool forbid(const std::set<FrameId>& links, Stamp time);

  /// Names the holes into which scenes fell, with their times.
  void report(base::Diagnostics& diagnostics) const;

 private:
  struct Hole {
    Gap gap;
    bool is_forbidden = false;
    std::int64_t scenes = 0;
  };

  [[nodiscard]] std::string message(FrameId child, const Hole& hole) const;

  const FrameTree& tree_;
  const TimelineOptions& options_;
  std::map<std::pair<FrameId, Stamp>, Hole> holes_;  ///< by frame and beginning
};

}  // namespace synthetic_dataset::motion
