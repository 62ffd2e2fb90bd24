#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/frame_names.h"
#include "motion/tf/link_history.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// Whether one frame can be transformed into another at a time.
struct Connection {
  bool known = false;
  Validity validity;  ///< times at which the answer and the path are the same

  /// The frames whose links to their parents are crossed on the path, up from the source and down
  /// to the target; empty unless known.
  std::vector<FrameId> links;
};

/// The tree of frames over time: each frame's parent and its pose in it. Gives the same answers as
/// tf2's buffer, and in addition how long an answer holds, so that long recordings can be searched
/// in a few steps.
class FrameTree {
 public:
  [[nodiscard]] FrameId findOrAdd(const std::string& name);
  [[nodiscard]] const FrameNames& names() const { return names_; }

  void setLink(FrameId child, LinkHistory link);
  [[nodiscard]] const LinkHistory& link(FrameId child) const;

  /// X_TS at a time, with normalised rotation; nothing if the frames are not connected then.
  [[nodiscard]] std::optional<Pose> transform(FrameId target, FrameId source, Stamp time) const;

  /// Whether there is such a transform.
  [[nodiscard]] Connection connection(FrameId target, FrameId source, Stamp time) const;

  /// All times at which `source` can be transformed into `target`, as disjoint ascending intervals.
  [[nodiscard]] std::vector<Validity> knownTimes(FrameId target, FrameId source) const;

  /// Whether links connect the two frames, regardless of when these links are known.
  [[nodiscard]] bool everLinked(FrameId a, FrameId b) const;

 private:
  [[nodiscard]] FrameId parentOf(FrameId frame, Stamp time) const {
    return link(frame).parentAt(time).frame;
  }

  FrameNames names_;
  std::vector<LinkHistory> links_;
};

}  // namespace synthetic_dataset::motion
