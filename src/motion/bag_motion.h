#pragma once

#include <memory>
#include <string>
#include <vector>

#include "motion/timeline.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// Where everything was while a recording was made: the TF tree of one or more bags.
///
/// Bags given together count as one recording. Leading slashes of frame names are stripped, of
/// those in the bag and of those asked for. Interpolation is tf2's own.
class BagMotion {
 public:
  /// Reads `/tf` and `/tf_static` of the bags, whole: interpolation may cross any length of time.
  /// @throws ErrorList with what is wrong with each file: missing, no bag, truncated (with what to
  ///     do about it), messages of another type; or no transform in any of them
  explicit BagMotion(const std::vector<std::string>& bag_files);
  ~BagMotion();
  BagMotion(BagMotion&&) noexcept;
  BagMotion& operator=(BagMotion&&) noexcept;

  /// The earliest and latest record times of the bags' messages, of any topic.
  [[nodiscard]] Stamp start() const;
  [[nodiscard]] Stamp end() const;

  [[nodiscard]] bool knowsFrame(const std::string& frame) const;

  /// "; did you mean 'alpha/base_link'?" about a frame that it does not know, or nothing.
  [[nodiscard]] std::string suggestFrame(const std::string& frame) const;

  /// X_target_source at `time`, its rotation normalised.
  /// @param time  above 0: what is "the latest" to tf2 is no time here
  /// @throws Error with tf2's reason
  [[nodiscard]] Pose transform(const std::string& target, const std::string& source,
                               Stamp time) const;

  /// Whether transform() has an answer.
  [[nodiscard]] bool canTransform(const std::string& target, const std::string& source,
                                  Stamp time) const;

  /// The times at which every frame of `frames` can be transformed into `global_frame`.
  ///
  /// Start: the first recording start + start_offset + k * period at which all can; end: found in
  /// the same way backwards from the recording's end (or that of `duration`); scenes while
  /// time < end. In between, single scenes are left out as the Timeline's counts tell.
  /// @throws ErrorList when there is none: per frame from when to when it is known, or, for a frame
  ///     that does not exist, those that are spelt nearly like it; options that leave nothing of
  ///     the recording, or more scenes than file names can number
  [[nodiscard]] Timeline timeline(const std::string& global_frame,
                                  const std::vector<std::string>& frames,
                                  const TimelineOptions& options) const;

  /// What the user should know about the recording: transforms that were left out, and why.
  [[nodiscard]] const std::vector<std::string>& notes() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::motion
