#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "motion/frame_source.h"
#include "motion/motion_options.h"
#include "motion/tf/bag_reader.h"
#include "motion/tf/frame_findings.h"
#include "motion/tf/frame_tree.h"
#include "motion/tf/joint_frames.h"
#include "motion/tf/stretches.h"

namespace synthetic_dataset::motion {

/// What is read of a recording.
struct BagMotionOptions {
  std::vector<std::string> bag_files;
  std::string global_frame = "map";
  std::optional<std::size_t> stretch = std::nullopt;  ///< where time goes back; none: the longest
  std::vector<std::string> tf_topics = {};            ///< none: findTfTopics()
  std::vector<PoseTopic> pose_topics = {};
  std::vector<std::string> frames =
      {};  ///< that should be known: other topics than TF may have them

  /// The objects whose models have joints; asked for where there are joint states.
  std::function<std::vector<JointedRobot>()> robots = {};
};

/// Where everything was while a recording was made: the TF tree of one or more bags.
///
/// Bags given together count as one recording. Interpolation is tf2's own, to the last bit.
class BagMotion : public FrameSource {
 public:
  /// Reads the bags' TF, and what other topics have of frames, whole: interpolation may cross any
  /// length of time.
  /// @throws ErrorList with what is wrong with each file: missing, no bag, truncated (with what to
  ///     do about it), messages of another type; or no transform in any of them
  explicit BagMotion(const BagMotionOptions& options);

  /// Reads TF alone.
  BagMotion(const std::vector<std::string>& bag_files, const std::string& global_frame)
      : BagMotion(BagMotionOptions{bag_files, global_frame}) {}

  /// The earliest and latest record times of the bags' messages, of any topic.
  [[nodiscard]] const RecordedTimes& times() const { return times_; }

  /// Whether its time stamps are of another clock than its record times, or of one stretch of it
  /// alone: then the times of scenes do not follow from its record times.
  [[nodiscard]] bool hasOwnClock() const;

  [[nodiscard]] const FrameNames& names() const override { return tree_.names(); }

  /// At times above 0: tf2's "latest" is not a time here.
  [[nodiscard]] std::optional<Pose> pose(FrameId frame, Stamp time) const override;

  [[nodiscard]] std::optional<Duration> recordedPeriod(FrameId frame, Stamp time) const override;

  /// Start: the first recording start + start_offset + k * period at which all can be transformed
  /// into the global frame; end: found in the same way backwards from the recording's end (or that
  /// of `duration`); scenes while time < end. In between, single scenes are left out, as the
  /// Timeline's counts say. With a clock of its own, the recording's start and end are the first
  /// and last time at which all can be transformed.
  /// @throws ErrorList when there is none: per frame from when to when it is known, or, for a frame
  ///     that does not exist, those that are spelt nearly like it; options that leave nothing of
  ///     the recording, or more scenes than file names can number
  [[nodiscard]] Timeline timeline(const std::vector<std::string>& frames,
                                  const TimelineOptions& options) const override;

  [[nodiscard]] std::string title() const override { return "the recording"; }

  /// Transforms that were left out, and why; stretches; what is odd about the frames.
  void report(const std::vector<FrameId>& frames, base::Diagnostics& diagnostics) const override;

  [[nodiscard]] std::string whenKnown(FrameId frame) const override;
  [[nodiscard]] bool isInHole(FrameId frame, Stamp time,
                              const std::optional<Duration>& max_tf_gap) const override;

 private:
  [[nodiscard]] std::vector<FrameId> withAncestors(std::vector<FrameId> frames) const;
  void noteClock(Stamp start, base::Diagnostics& diagnostics) const;

  RecordedTimes times_;
  FrameTree tree_;
  FrameId global_ = kNoFrame;
  std::vector<std::string> notes_;
  std::vector<std::string> hints_;  ///< of other topics, where frames are missing
  std::string lacks_static_;        ///< the same, of what is recorded but once
  std::vector<Stretch> stretches_;
  std::size_t stretch_ = 0;
  Duration clock_offset_{0};  ///< of the stamps behind the record times
  std::vector<FrameFinding> findings_;
};

}  // namespace synthetic_dataset::motion
