#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// When scenes are made: at regular times, or at the given ones; in a recording, from its start +
/// start_offset on.
struct TimelineOptions {
  Duration period{0};                ///< between scenes, > 0
  Duration start_offset{0};          ///< skipped at the recording's start, >= 0
  std::optional<Duration> duration;  ///< of the part that is used, counted from start_offset

  /// Scenes interpolated across a longer gap are left out, unless the pose is the same at both
  /// ends. Nothing: for each frame, the larger of 10 s and 20 median periods.
  std::optional<Duration> max_tf_gap;

  /// Frames that need not be known in every scene: without them, scenes lack what they move. The
  /// source has to have these frames at some time.
  std::vector<std::string> sometimes = {};

  /// The times of recorded pictures or clouds, used instead of regular times; ascending.
  std::optional<std::vector<Stamp>> stamps;

  std::int64_t scenes = 0;  ///< number of scenes, if there is no recording

  /// How much later than its regular time a scene is made, by the regular time's index from 0; any
  /// two values differ by less than a period. Empty: no jitter.
  std::function<Duration(std::int64_t index)> jitter;
};

/// A frame that is not known throughout the used part of the recording.
struct FrameCost {
  std::string frame;
  Duration unknown{0};  ///< for how long
  std::string why;      ///< "TF has 'odom' in 'map' from 1.000 s to 3.000 s", the link to blame
};

/// The times of all scenes of a run, found before the first scene is made.
struct Timeline {
  std::vector<Stamp> stamps;          ///< of the scenes to make, ascending
  std::vector<Duration> jitter;       ///< of each of these; empty if there is none
  std::int64_t left_out_gap = 0;      ///< scenes left out because of max_tf_gap
  std::int64_t left_out_unknown = 0;  ///< scenes left out because a transform was not known
  std::int64_t left_out_split = 0;    ///< scenes left out in gaps between splits
  Duration used{0};                   ///< of the recording: the part that could have scenes
  std::vector<FrameCost> costs;       ///< of a recording's frames, including those of `sometimes`
  base::Diagnostics diagnostics;      ///< what the user should know: holes in the recording, ...
  bool is_recorded = true;            ///< otherwise the times only number scenes that are
                                      ///< independent of one another
};

/// 1/rate truncated to whole nanoseconds, as the original does: 30 Hz is 33333333 ns. If the period
/// is meant to be a whole number of nanoseconds, it is that number: 10 Hz is 100000000 ns.
/// @param rate  [Hz], > 0
/// @throws Error for a rate that has no such period
[[nodiscard]] Duration periodOf(double rate);

/// Times per second, from the median time between consecutive ones; nothing for a single one.
/// @param stamps  ascending
[[nodiscard]] std::optional<double> usualRate(const std::vector<Stamp>& stamps);

}  // namespace synthetic_dataset::motion
