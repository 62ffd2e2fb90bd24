#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "motion/frame_source.h"

namespace synthetic_dataset::motion {

/// Frames that are placed anew for each scene, over a source that has all others. A copy keeps what
/// is placed as it is, for use in another thread.
class PlacedFrames : public FrameSource {
 public:
  explicit PlacedFrames(std::shared_ptr<const FrameSource> others);

  /// Puts a frame somewhere, from now on and whatever the other source has of it; at set-up, as
  /// all copies have the same names.
  /// @param X_GF  nothing: the frame is not there, and so not known at any time
  FrameId place(const std::string& frame, const std::optional<Pose>& X_GF);

  /// The same for a frame of names().
  void place(FrameId frame, const std::optional<Pose>& X_GF);

  /// From now on a frame is not known where it would be interpolated across a hole.
  /// @param max_tf_gap  as in TimelineOptions
  void forgetInHoles(FrameId frame, const std::optional<Duration>& max_tf_gap);

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
  std::shared_ptr<FrameNames> names_;  ///< those of the others, and those that are placed
  std::map<FrameId, std::optional<Pose>> placed_;             ///< X_GF
  std::map<FrameId, std::optional<Duration>> without_holes_;  ///< the longest gap of each
};

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
