#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "motion/tf/recorded_transform.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// A frame's transform in the order in which they came.
struct ArrivedStamp {
  Stamp stamp{0};
  Arrival arrival;
};

/// A part of a recording in which time goes forward.
struct Stretch {
  Stamp first{0};
  Stamp last{0};
};

/// Where a recording is cut because time goes back in it.
struct Cuts {
  /// The transform with which each frame's next stretch begins: by frame, one per cut, ascending.
  std::vector<std::vector<Arrival>> of_frames;
  std::vector<Arrival> all;  ///< the first of each cut, of any frame

  /// The steps back of single frames, by frame, while the stamps of most others go on; ascending.
  std::map<std::size_t, std::vector<Arrival>> alone;

  /// The index of the stretch to which a frame's transform belongs.
  [[nodiscard]] std::size_t stretchOf(std::size_t frame, const Arrival& arrival) const;
};

/// Finds where time goes back for good, as when a simulation is reset: the stamps of most frames
/// drop at about the same time, and go on from there. What comes late, out of order, or from two
/// publishers with different delays, returns to where it was and is not a cut.
/// @param frames  of each frame, ascending by arrival, without repetitions of a transform
[[nodiscard]] Cuts findCuts(const std::vector<std::vector<ArrivedStamp>>& frames);

/// "0: 1.000 s to 9.000 s (8.000 s)", ... for messages.
[[nodiscard]] std::string stretchList(const std::vector<Stretch>& stretches);

/// The index of the longest.
[[nodiscard]] std::size_t longestOf(const std::vector<Stretch>& stretches);

/// Stamps that are less than this from the recording's clock have it.
inline constexpr Duration kSameClock = std::chrono::seconds(1);

/// A transform of a frame, when it was and when it came.
struct TimedTransform {
  Stamp stamp{0};
  Stamp recorded{0};
  Arrival arrival;
};

/// Which of a frame's transforms count whose stamps go back while those of other frames go on, as
/// when a sensor's clock is set: poses of before and after are never mixed. Of the parts between
/// the steps back, those count that have the recording's clock (if none has, the one that comes
/// next to it); of these, each from its first stamp on, and the one before it up to there.
/// @param transforms  in any order
/// @param steps  with which transforms the stamps go back, ascending
/// @param clock_offset  by how much the recording's stamps are behind its record times
/// @return their indices, ascending
[[nodiscard]] std::vector<std::size_t> withoutMixedTimes(
    const std::vector<TimedTransform>& transforms, const std::vector<Arrival>& steps,
    Duration clock_offset);

}  // namespace synthetic_dataset::motion
