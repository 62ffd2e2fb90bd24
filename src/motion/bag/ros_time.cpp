#include "motion/bag/ros_time.h"

#include <cstdint>

namespace synthetic_dataset::motion {

std::string secondsText(Duration time) {
  constexpr std::int64_t kNanosecondsPerSecond = 1000000000;
  const std::int64_t seconds = time.count() / kNanosecondsPerSecond;
  const std::int64_t rest = time.count() % kNanosecondsPerSecond;
  const std::string decimals = std::to_string(rest < 0 ? -rest : rest);
  const std::string sign = time.count() < 0 && seconds == 0 ? "-" : "";
  return sign + std::to_string(seconds) + "." + std::string(9 - decimals.size(), '0') + decimals +
         " s";
}

}  // namespace synthetic_dataset::motion
