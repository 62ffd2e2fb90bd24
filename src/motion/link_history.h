#pragma once

#include <cstdint>
#include <vector>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// A frame's place in the list of frames.
using FrameIndex = std::int32_t;
constexpr FrameIndex kNoFrame = -1;

/// The times over which an answer stays the same, both ends included.
struct Validity {
  Stamp from = Stamp::min();
  Stamp until = Stamp::max();

  void intersect(const Validity& other);
};

/// To which parent a frame is linked over time, by tf2's rules: nothing is known before the first
/// and after the last sample; between two samples the parent is the earlier one's.
class LinkHistory {
 public:
  struct Sample {
    Stamp stamp;
    FrameIndex parent;
  };
  struct Parent {
    FrameIndex frame = kNoFrame;  ///< kNoFrame where nothing is known
    Validity validity;
  };

  /// Never linked: a root.
  LinkHistory() = default;

  /// A link of `/tf_static`: holds at all times.
  [[nodiscard]] static LinkHistory fixedTo(FrameIndex parent);

  /// A link of `/tf`.
  /// @param samples  at least one, with ascending stamps
  [[nodiscard]] static LinkHistory sampledAt(const std::vector<Sample>& samples);

  [[nodiscard]] Parent parentAt(Stamp time) const;

  /// How far apart the samples are between which tf2 interpolates; 0 where it need not: at a
  /// sample, for a static link.
  [[nodiscard]] Duration gapAt(Stamp time) const;

  /// All parents that it ever had, in order of time.
  [[nodiscard]] std::vector<FrameIndex> parents() const;

 private:
  FrameIndex fixed_parent_ = kNoFrame;
  std::vector<Stamp> stamps_;
  std::vector<Sample> changes_;  ///< the samples whose parent is another than that before
};

}  // namespace synthetic_dataset::motion
