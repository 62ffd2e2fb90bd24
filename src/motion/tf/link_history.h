#pragma once

#include <optional>
#include <vector>

#include <geometry_msgs/Transform.h>

#include "motion/frame_names.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// The times over which an answer stays the same, both ends included.
struct Validity {
  Stamp from = Stamp::min();
  Stamp until = Stamp::max();

  void intersect(const Validity& other);
};

/// A time without samples.
struct Gap {
  Stamp from{0};
  Stamp until{0};
  bool is_still = false;  ///< whether the pose is the same at both ends, except for noise

  [[nodiscard]] Duration length() const { return until - from; }
};

/// A frame's parent, and the frame's pose in it, over time, by tf2's rules: nothing is known before
/// the first and after the last sample; between two samples the parent is the earlier one's.
class LinkHistory {
 public:
  struct Sample {
    Stamp stamp;
    FrameId parent;
    geometry_msgs::Transform X_PC = {};  ///< P parent, C child
  };
  struct Parent {
    FrameId frame = kNoFrame;  ///< kNoFrame where nothing is known
    Validity validity;
  };

  /// A frame that never has a parent: a root.
  LinkHistory() = default;

  /// A link of `/tf_static`: holds at all times.
  [[nodiscard]] static LinkHistory fixedTo(FrameId parent,
                                           const geometry_msgs::Transform& X_PC = {});

  /// A link of `/tf_static` that was changed: each value holds until the next one, the first one
  /// also before its time.
  /// @param samples  at least one, with ascending stamps
  [[nodiscard]] static LinkHistory heldFrom(std::vector<Sample> samples);

  /// A link of `/tf`.
  /// @param samples  at least one, with ascending stamps
  [[nodiscard]] static LinkHistory sampledAt(std::vector<Sample> samples);

  [[nodiscard]] Parent parentAt(Stamp time) const;

  /// X_PC at a time at which parentAt() knows a parent; matches tf2's interpolation to the last
  /// bit.
  [[nodiscard]] geometry_msgs::Transform transformAt(Stamp time) const;

  /// The interval between the samples between which tf2 interpolates; nothing if it need not: at a
  /// sample, or for a static link.
  [[nodiscard]] std::optional<Gap> gapAt(Stamp time) const;

  /// The median time between consecutive samples; 0 if there are fewer than two.
  [[nodiscard]] Duration medianPeriod() const { return median_period_; }

  /// All parents that it ever had, in order of time.
  [[nodiscard]] std::vector<FrameId> parents() const;

 private:
  struct Change {
    Stamp stamp;
    FrameId parent;
  };

  using Samples = std::vector<Sample>;
  [[nodiscard]] Samples::const_iterator firstFrom(Stamp time) const;

  bool is_held_ = false;  ///< rather than interpolated
  Samples samples_;
  Duration median_period_{0};
  std::vector<Change> changes_;  ///< samples whose parent differs from the previous sample's
};

}  // namespace synthetic_dataset::motion
