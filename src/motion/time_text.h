#pragma once

#include <string>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// Seconds with all nine decimals, exact for any time since the epoch: "1650000002.623456789 s".
/// (A double of seconds is off by up to 0.1 microseconds there.)
[[nodiscard]] std::string secondsText(Duration time);

}  // namespace synthetic_dataset::motion
