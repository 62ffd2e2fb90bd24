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

/// What to read from a recording.
struct BagMotionOptions {
  std::vector<std::string> bag_files;
  std::string global_frame = "map";
  std::optional<std::size_t> stretch = std::nullopt;  ///< if time goes back; none: the longest
  std::vector<std::string> tf_topics = {};            ///< empty: findTfTopics()
  std::vector<PoseTopic> pose_topics = {};
  std::vector<std::string> frames =
      {};  ///< that should be known; they may come from topics other than TF

  /// Returns the objects whose models have joints; called only if there are joint states.
  std::function<std::vector<JointedRobot>()> robots = {};
};

/// Where everything was during a recording: the TF tree of one or more bags.
///
/// Bags given together count as one recording. Interpolation matches tf2's to the last bit.
class BagMotion : public FrameSource {
 public:
  /// Reads all of the bags' TF, and the frames that other topics give: interpolation may cross any
  /// length of time.
  /// @throws ErrorList with what is wrong with each file: missing, not a bag, truncated (with what
  ///     to do about it), messages of another type; or if there is no transform in any of them
  explicit BagMotion(const BagMotionOptions& options);

  /// Reads only TF.
  BagMotion(const std::vector<std::string>& bag_files, const std::string& global_frame)
      : BagMotion(BagMotionOptions{bag_files, global_frame}) {}

  /// The earliest and latest record times of the bags' messages, of any topic.
  [[nodiscard]] const RecordedTimes& times() const { return times_; }

  /// Whether its time stamps are from another clock than its record times, or only one of several
  /// stretches is used: then the times of scenes do not follow from the record times.
  [[nodiscard]] bool hasOwnClock() const;

  [[nodiscard]] const FrameNames& names() const override { return tree_.names(); }

  /// Only at times above 0: 0, tf2's "latest", is not supported.
  [[nodiscard]] std::optional<Pose> pose(FrameId frame, Stamp time) const override;

  [[nodiscard]] std::optional<Duration> recordedPeriod(FrameId frame, Stamp time) const override;

  /// Start: the first of the times recording start + start_offset + k * period at which all frames
  /// can be transformed into the global frame. End: found in the same way, backwards from the end
  /// of the recording (or of `duration`). There are scenes while time < end; single scenes in
  /// between are left out as counted in the Timeline. If the recording has a clock of its own, its
  /// start and end are the first and last time at which all frames can be transformed.
  /// @throws ErrorList if there are no scenes: for each frame, when it is known, or, if it does not
  ///     exist, similarly spelt ones; also if the options leave nothing of the recording, or give
  ///     more scenes than file names can number
  [[nodiscard]] Timeline timeline(const std::vector<std::string>& frames,
                                  const TimelineOptions& options) const override;

  [[nodiscard]] std::string title() const override { return "the recording"; }

  /// Reports transforms that were left out, and why; stretches; what is odd about the frames.
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
  std::vector<std::string> hints_;  ///< about other topics, if frames are missing
  std::string lacks_static_;        ///< the same, about static frames, which are recorded only once
  std::vector<Stretch> stretches_;
  std::size_t stretch_ = 0;
  Duration clock_offset_{0};  ///< by which the stamps are behind the record times
  std::vector<FrameFinding> findings_;
};

}  // namespace synthetic_dataset::motion
