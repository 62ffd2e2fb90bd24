#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "motion/tf/recorded_transform.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// The stamp of a frame's transform, and when it arrived.
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
  /// The first transform of each frame after each cut: by frame, one per cut, ascending.
  std::vector<std::vector<Arrival>> of_frames;
  std::vector<Arrival> all;  ///< the first of each cut over all frames

  /// Steps back of single frames while the stamps of most others go on; by frame, ascending.
  std::map<std::size_t, std::vector<Arrival>> alone;

  /// The index of the stretch to which a frame's transform belongs.
  [[nodiscard]] std::size_t stretchOf(std::size_t frame, const Arrival& arrival) const;
};

/// Finds where time goes back for good, as when a simulation is reset: the stamps of most frames
/// drop at about the same time, and go on from there. Stamps of transforms that are late, out of
/// order, or from two publishers with different delays return to where they were, which is not a
/// cut.
/// @param frames  the transforms of each frame, ascending by arrival, without repeated transforms
[[nodiscard]] Cuts findCuts(const std::vector<std::vector<ArrivedStamp>>& frames);

/// "0: 1.000 s to 9.000 s (8.000 s)", ... for messages.
[[nodiscard]] std::string stretchList(const std::vector<Stretch>& stretches);

/// The index of the longest stretch.
[[nodiscard]] std::size_t longestOf(const std::vector<Stretch>& stretches);

/// Stamps that differ less than this from the recording's clock count as being of that clock.
inline constexpr Duration kSameClock = std::chrono::seconds(1);

/// The times of a frame's transform: its stamp, when it was recorded, and when it arrived.
struct TimedTransform {
  Stamp stamp{0};
  Stamp recorded{0};
  Arrival arrival;
};

/// Selects the transforms to use of a frame whose stamps go back while those of other frames go on,
/// as when a sensor's clock is set: poses from before and after are never mixed. Of the parts
/// between the steps back, only those in the recording's clock are used (if there are none, the
/// part that is nearest to it). Each of these counts from its first stamp on, and the one before it
/// up to there.
/// @param transforms  in any order
/// @param steps  the transforms at which the stamps go back, ascending
/// @param clock_offset  by how much the recording's stamps are behind its record times
/// @return the indices of the selected transforms, ascending
[[nodiscard]] std::vector<std::size_t> withoutMixedTimes(
    const std::vector<TimedTransform>& transforms, const std::vector<Arrival>& steps,
    Duration clock_offset);

}  // namespace synthetic_dataset::motion
