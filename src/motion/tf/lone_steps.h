#pragma once

#include <cstddef>
#include <vector>

#include "motion/tf/recorded_transform.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

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
