#pragma once

#include <cmath>
#include <cstdint>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::base {

/// Converts a duration given in seconds by the parameters, rounded to the nearest nanosecond.
[[nodiscard]] inline Duration fromSeconds(double seconds) {
  return Duration(static_cast<std::int64_t>(std::llround(seconds * 1e9)));
}

}  // namespace synthetic_dataset::base
