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
  Validity validity;  ///< times at which the answer is the same and goes the same way

  /// The frames whose links to their parents are crossed on the way, up from the source and down to
  /// the target; empty unless known.
  std::vector<FrameId> links;
};

/// Which frame hung below which one, when and where. It answers as tf2's buffer does, and says in
/// addition how long an answer holds, so that long recordings are searched in a few steps.
class FrameTree {
 public:
  [[nodiscard]] FrameId findOrAdd(const std::string& name);
  [[nodiscard]] const FrameNames& names() const { return names_; }

  void setLink(FrameId child, LinkHistory link);
  [[nodiscard]] const LinkHistory& link(FrameId child) const;

  /// X_TS at a time, its rotation normalised; nothing where they are not connected then.
  [[nodiscard]] std::optional<Pose> transform(FrameId target, FrameId source, Stamp time) const;

  /// Whether there is such a transform.
  [[nodiscard]] Connection connection(FrameId target, FrameId source, Stamp time) const;

  /// All times at which `source` can be transformed into `target`: apart and ascending.
  [[nodiscard]] std::vector<Validity> knownTimes(FrameId target, FrameId source) const;

  /// Whether links connect the two frames when it is left aside at which times they are known.
  [[nodiscard]] bool everLinked(FrameId a, FrameId b) const;

 private:
  [[nodiscard]] FrameId parentOf(FrameId frame, Stamp time) const {
    return link(frame).parentAt(time).frame;
  }

  FrameNames names_;
  std::vector<LinkHistory> links_;
};

}  // namespace synthetic_dataset::motion
