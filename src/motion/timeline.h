#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// When scenes are made: at regular times, or at those that are given; of a recording, from its
/// start + start_offset on.
struct TimelineOptions {
  Duration period{0};                ///< between scenes, > 0
  Duration start_offset{0};          ///< left out at the recording's start, >= 0
  std::optional<Duration> duration;  ///< of the part that is used, counted from start_offset

  /// Scenes interpolated across a longer gap are left out, unless the pose is the same at both
  /// ends. Nothing: of each frame the larger of 10 s and 20 median periods.
  std::optional<Duration> max_tf_gap;

  /// Frames that scenes need not know: they are made without what these move. The source has to
  /// have them.
  std::vector<std::string> sometimes = {};

  /// Instead of regular times, those at which there is something recorded; ascending.
  std::optional<std::vector<Stamp>> stamps;

  std::int64_t scenes = 0;  ///< how many, where no recording has a start and an end

  /// How much later than at its regular time a scene is made, by the regular time's index from 0;
  /// any two less than a period apart. Nothing: not at all.
  std::function<Duration(std::int64_t index)> jitter;
};

/// A frame that is not known in all of the part of the recording that is used.
struct FrameCost {
  std::string frame;
  Duration unknown{0};  ///< for how long
  std::string why;      ///< "TF has 'odom' in 'map' from 1.000 s to 3.000 s", the link to blame
};

/// The times of all scenes of a run, found before the first one is made.
struct Timeline {
  std::vector<Stamp> stamps;          ///< of the scenes to make, ascending
  std::vector<Duration> jitter;       ///< in each of these; empty where there is none
  std::int64_t left_out_gap = 0;      ///< scenes left out because of max_tf_gap
  std::int64_t left_out_unknown = 0;  ///< scenes left out because a transform was not known
  std::int64_t left_out_split = 0;    ///< scenes left out in gaps between splits
  Duration used{0};                   ///< of the recording: what could have scenes
  std::vector<FrameCost> costs;       ///< of a recording's frames, those of `sometimes` as well
  base::Diagnostics diagnostics;      ///< what the user should know: holes in the recording, ...
  bool is_recorded = true;            ///< else the times only number scenes that have nothing to
                                      ///< do with one another
};

/// 1/rate cut to whole nanoseconds, as the original does: 30 Hz is 33333333 ns.
/// Where the rate means a whole number of nanoseconds it is that number: 10 Hz is 100000000 ns.
/// @param rate  [Hz], > 0
/// @throws Error for a rate that has no such period
[[nodiscard]] Duration periodOf(double rate);

/// Times in a second, by the median of the time from one to the next; nothing for a single one.
/// @param stamps  ascending
[[nodiscard]] std::optional<double> usualRate(const std::vector<Stamp>& stamps);

}  // namespace synthetic_dataset::motion
