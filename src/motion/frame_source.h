#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "motion/frame_names.h"
#include "motion/timeline.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// A source of motion: the poses of frames over time, in the global frame G. Sources can be queried
/// from several threads at once after set-up.
class FrameSource {
 public:
  /// @param global_frame  with or without leading slashes; the source need not have it
  explicit FrameSource(const std::string& global_frame)
      : global_frame_(withoutLeadingSlashes(global_frame)) {}
  virtual ~FrameSource() = default;

  [[nodiscard]] const std::string& globalFrame() const { return global_frame_; }

  /// All frames that it knows at some time at least.
  [[nodiscard]] virtual const FrameNames& names() const = 0;

  [[nodiscard]] std::optional<FrameId> find(const std::string& frame) const {
    return names().find(frame);
  }

  /// X_GF, with normalised rotation; nothing at times at which it is not known, and for kNoFrame.
  [[nodiscard]] virtual std::optional<Pose> pose(FrameId frame, Stamp time) const = 0;

  /// X_GF.
  /// @throws Error if it is not known
  [[nodiscard]] Pose knownPose(FrameId frame, Stamp time) const;

  /// The shortest of the median periods of the recorded transforms that connect a frame with the
  /// global one at a time. Nothing if all of them are static, or none are recorded.
  [[nodiscard]] virtual std::optional<Duration> recordedPeriod(FrameId frame, Stamp time) const {
    static_cast<void>(frame);
    static_cast<void>(time);
    return std::nullopt;
  }

  /// The times of the scenes, at each of which all of these frames are known.
  /// @throws ErrorList if there are none, saying why: frames that the source lacks, options that
  ///     leave no time, ...
  [[nodiscard]] virtual Timeline timeline(const std::vector<std::string>& frames,
                                          const TimelineOptions& options) const = 0;

  /// What the source is called in messages: "the recording".
  [[nodiscard]] virtual std::string title() const = 0;

  /// "the recording has no frame 'bass'; did you mean 'base'?"
  [[nodiscard]] std::string lacks(const std::string& frame) const;

  /// Reports what the user should know about the source.
  /// @param frames  that are used; oddities of other frames are not reported
  virtual void report(const std::vector<FrameId>& frames, base::Diagnostics& diagnostics) const {
    static_cast<void>(frames);
    static_cast<void>(diagnostics);
  }

  /// Whether a pose at this time would be interpolated across a hole that TimelineOptions forbids.
  [[nodiscard]] virtual bool isInHole(FrameId frame, Stamp time,
                                      const std::optional<Duration>& max_tf_gap) const {
    static_cast<void>(frame);
    static_cast<void>(time);
    static_cast<void>(max_tf_gap);
    return false;
  }

  /// "; it is known from 1.000000000 s to 3.000000000 s" for the end of a message, or nothing.
  [[nodiscard]] virtual std::string whenKnown(FrameId frame) const {
    static_cast<void>(frame);
    return "";
  }

 protected:
  FrameSource(const FrameSource&) = default;
  FrameSource& operator=(const FrameSource&) = default;

 private:
  std::string global_frame_;
};

}  // namespace synthetic_dataset::motion
