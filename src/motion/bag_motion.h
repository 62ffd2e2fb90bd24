#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/bag_reader.h"
#include "motion/frame_source.h"
#include "motion/frame_tree.h"

namespace synthetic_dataset::motion {

/// Where everything was while a recording was made: the TF tree of one or more bags.
///
/// Bags given together count as one recording. Interpolation is tf2's own, to the last bit.
class BagMotion : public FrameSource {
 public:
  /// Reads `/tf` and `/tf_static` of the bags, whole: interpolation may cross any length of time.
  /// @throws ErrorList with what is wrong with each file: missing, no bag, truncated (with what to
  ///     do about it), messages of another type; or no transform in any of them
  BagMotion(const std::vector<std::string>& bag_files, const std::string& global_frame);

  /// The earliest and latest record times of the bags' messages, of any topic.
  [[nodiscard]] const RecordedTimes& times() const { return times_; }

  [[nodiscard]] const FrameNames& names() const override { return tree_.names(); }

  /// At times above 0: what is "the latest" to tf2 is no time here.
  [[nodiscard]] std::optional<Pose> pose(FrameId frame, Stamp time) const override;

  /// Start: the first recording start + start_offset + k * period at which all can be transformed
  /// into the global frame; end: found in the same way backwards from the recording's end (or that
  /// of `duration`); scenes while time < end. In between, single scenes are left out, as the
  /// Timeline's counts say.
  /// @throws ErrorList when there is none: per frame from when to when it is known, or, for a frame
  ///     that does not exist, those that are spelt nearly like it; options that leave nothing of
  ///     the recording, or more scenes than file names can number
  [[nodiscard]] Timeline timeline(const std::vector<std::string>& frames,
                                  const TimelineOptions& options) const override;

  [[nodiscard]] std::string title() const override { return "the recording"; }

  /// Transforms that were left out, and why.
  [[nodiscard]] std::vector<std::string> notes() const override { return notes_; }

 private:
  RecordedTimes times_;
  FrameTree tree_;
  FrameId global_ = kNoFrame;
  std::vector<std::string> notes_;
};

}  // namespace synthetic_dataset::motion
