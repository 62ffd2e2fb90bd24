#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "motion/frame_source.h"

namespace synthetic_dataset::motion {

/// Frames that are placed anew for each scene, on top of a source of all other frames. A copy keeps
/// its placed frames unchanged, for use in another thread.
class PlacedFrames : public FrameSource {
 public:
  explicit PlacedFrames(std::shared_ptr<const FrameSource> others);

  /// Places a frame from now on, overriding the other source; only during set-up, as all copies
  /// share their names.
  /// @param X_GF  nothing if the frame is absent, and so not known at any time
  FrameId place(const std::string& frame, const std::optional<Pose>& X_GF);

  /// The same for a frame of names().
  void place(FrameId frame, const std::optional<Pose>& X_GF);

  /// From now on, treats a frame as unknown at times at which it would be interpolated across a
  /// hole.
  /// @param max_tf_gap  as in TimelineOptions
  void markAbsentInGaps(FrameId frame, const std::optional<Duration>& max_tf_gap);

  [[nodiscard]] bool isPlaced(const std::string& frame) const;

  [[nodiscard]] const FrameNames& names() const override { return *names_; }
  [[nodiscard]] std::optional<Pose> pose(FrameId frame, Stamp time) const override;
  [[nodiscard]] std::optional<Duration> recordedPeriod(FrameId frame, Stamp time) const override;
  [[nodiscard]] Timeline timeline(const std::vector<std::string>& frames,
                                  const TimelineOptions& options) const override;
  [[nodiscard]] std::string title() const override { return others_->title(); }
  void report(const std::vector<FrameId>& frames, base::Diagnostics& diagnostics) const override;
  [[nodiscard]] std::string whenKnown(FrameId frame) const override;

 private:
  [[nodiscard]] bool isOfOthers(FrameId frame) const;

  std::shared_ptr<const FrameSource> others_;
  std::shared_ptr<FrameNames> names_;  ///< those of the others, then those that are placed
  std::map<FrameId, std::optional<Pose>> placed_;             ///< X_GF
  std::map<FrameId, std::optional<Duration>> without_holes_;  ///< the longest allowed gap of each
};

/// The motion of scenes that are placed at random: it has only the global frame, and as many times
/// as are asked for, which merely number the scenes.
class PlacementMotion : public FrameSource {
 public:
  explicit PlacementMotion(const std::string& global_frame);

  [[nodiscard]] const FrameNames& names() const override { return names_; }
  [[nodiscard]] std::optional<Pose> pose(FrameId frame, Stamp time) const override;

  /// The times one period after 0, two periods, ...
  /// @throws Error if the last one is more than 292 years from the first
  [[nodiscard]] Timeline timeline(const std::vector<std::string>& frames,
                                  const TimelineOptions& options) const override;
  [[nodiscard]] std::string title() const override { return "the placement"; }

 private:
  FrameNames names_;
};

}  // namespace synthetic_dataset::motion
