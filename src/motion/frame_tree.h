#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "motion/link_history.h"

namespace synthetic_dataset::motion {

/// Whether one frame can be transformed into another at a time.
struct Connection {
  bool known = false;
  Validity validity;  ///< times at which the answer is the same and goes the same way

  /// The frames whose links to their parents are crossed on the way, up from the source and down to
  /// the target; empty unless known.
  std::vector<FrameIndex> links;
};

/// Which frame hung below which one, and when. It answers as tf2's `canTransform` does, and says in
/// addition how long the answer holds, so that long recordings are searched in a few steps.
class FrameTree {
 public:
  [[nodiscard]] FrameIndex findOrAdd(const std::string& name);
  [[nodiscard]] std::optional<FrameIndex> find(const std::string& name) const;
  [[nodiscard]] const std::string& name(FrameIndex frame) const;

  /// All names in order of their first use.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

  void setLink(FrameIndex child, LinkHistory link);
  [[nodiscard]] const LinkHistory& link(FrameIndex child) const;

  [[nodiscard]] Connection connection(FrameIndex target, FrameIndex source, Stamp time) const;

  /// All times at which `source` can be transformed into `target`: apart and ascending.
  [[nodiscard]] std::vector<Validity> knownTimes(FrameIndex target, FrameIndex source) const;

  /// Whether links connect the two frames when it is left aside at which times they are known.
  [[nodiscard]] bool everLinked(FrameIndex a, FrameIndex b) const;

 private:
  std::unordered_map<std::string, FrameIndex> indices_;
  std::vector<std::string> names_;
  std::vector<LinkHistory> links_;
};

}  // namespace synthetic_dataset::motion
