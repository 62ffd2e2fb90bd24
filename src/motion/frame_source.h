#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "motion/frame_names.h"
#include "motion/timeline.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// A source of motion: where frames are at a time, in the global frame G. Sources can be asked from
/// several threads at a time, once set-up is over.
class FrameSource {
 public:
  /// @param global_frame  with or without leading slashes; the source need not have it
  explicit FrameSource(const std::string& global_frame)
      : global_frame_(withoutLeadingSlashes(global_frame)) {}
  virtual ~FrameSource() = default;

  [[nodiscard]] const std::string& globalFrame() const { return global_frame_; }

  /// All frames that it has, at some time at least.
  [[nodiscard]] virtual const FrameNames& names() const = 0;

  [[nodiscard]] std::optional<FrameId> find(const std::string& frame) const {
    return names().find(frame);
  }

  /// X_GF, its rotation normalised; nothing at times at which it is not known, and for kNoFrame.
  [[nodiscard]] virtual std::optional<Pose> pose(FrameId frame, Stamp time) const = 0;

  /// X_GF.
  /// @throws Error where it is not known
  [[nodiscard]] Pose knownPose(FrameId frame, Stamp time) const;

  /// The time from one recorded transform to the next (median) of all that lead from a frame to the
  /// global one at a time: of the most frequent. Nothing where all are static, or none are
  /// recorded.
  [[nodiscard]] virtual std::optional<Duration> recordedPeriod(FrameId frame, Stamp time) const {
    static_cast<void>(frame);
    static_cast<void>(time);
    return std::nullopt;
  }

  /// The times of the scenes, at each of which all of these frames are known.
  /// @throws ErrorList when there is none, saying why: frames that it does not have, options that
  ///     leave no time, ...
  [[nodiscard]] virtual Timeline timeline(const std::vector<std::string>& frames,
                                          const TimelineOptions& options) const = 0;

  /// What it is, for messages: "the recording".
  [[nodiscard]] virtual std::string title() const = 0;

  /// "the recording has no frame 'bass'; did you mean 'base'?"
  [[nodiscard]] std::string lacks(const std::string& frame) const;

  /// Notes what the user should know about it.
  /// @param frames  that are used; what is odd about others does not matter
  virtual void report(const std::vector<FrameId>& frames, base::Diagnostics& diagnostics) const {
    static_cast<void>(frames);
    static_cast<void>(diagnostics);
  }

  /// Whether a pose at this time would be interpolated across a hole that TimelineOptions forbid.
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
