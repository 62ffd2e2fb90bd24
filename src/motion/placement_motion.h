#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/frame_source.h"

namespace synthetic_dataset::motion {

/// The motion of scenes that are placed at random: it has nothing but the global frame, and as many
/// times as are asked for, which only number the scenes.
class PlacementMotion : public FrameSource {
 public:
  explicit PlacementMotion(const std::string& global_frame);

  [[nodiscard]] const FrameNames& names() const override { return names_; }
  [[nodiscard]] std::optional<Pose> pose(FrameId frame, Stamp time) const override;

  /// One period after 0, two periods, ...
  /// @throws Error when the last one is more than 292 years from the first
  [[nodiscard]] Timeline timeline(const std::vector<std::string>& frames,
                                  const TimelineOptions& options) const override;
  [[nodiscard]] std::string title() const override { return "the placement"; }

 private:
  FrameNames names_;
};

}  // namespace synthetic_dataset::motion
