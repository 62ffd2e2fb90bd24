#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include <ros/duration.h>
#include <ros/time.h>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// Whether `ros::Time` can hold it as an actual time: zero means "the latest" to tf2.
[[nodiscard]] inline bool isRosTime(Stamp stamp) {
  constexpr Stamp kEnd = std::chrono::seconds(std::numeric_limits<std::uint32_t>::max());
  return stamp > Stamp{0} && stamp < kEnd;
}

[[nodiscard]] inline Stamp toStamp(const ros::Time& time) {
  return std::chrono::seconds(time.sec) + std::chrono::nanoseconds(time.nsec);
}

[[nodiscard]] inline ros::Time toRosTime(Stamp stamp) {
  ros::Time time;
  return time.fromNSec(static_cast<std::uint64_t>(stamp.count()));
}

[[nodiscard]] inline ros::Duration toRosDuration(Duration duration) {
  ros::Duration result;
  return result.fromNSec(duration.count());
}

/// Seconds with all nine decimals, exact for any time since the epoch: "1650000002.623456789 s".
/// (A double of seconds is off by up to 0.1 microseconds there.)
[[nodiscard]] std::string secondsText(Duration time);

}  // namespace synthetic_dataset::motion
