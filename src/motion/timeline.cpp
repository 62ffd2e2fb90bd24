#include "motion/timeline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {

Duration periodOf(double rate) {
  constexpr double kNanosecondsPerSecond = 1e9;
  constexpr double kLongestPeriod = 1e18;  // [ns], 31 years
  const double period = kNanosecondsPerSecond / rate;
  if (!(rate > 0.0) || !(period >= 1.0 && period <= kLongestPeriod)) {
    std::ostringstream message;
    message << "a rate of " << rate
            << " Hz: it has to be above 0, and its period from 1 ns to 1e9 s";
    throw Error(message.str());
  }
  // A rate that is not an exact double (0.1, 1/3) gives a period a few units in the last place off
  // the intended one; truncation must not turn an intended 10 s into 9.999999999 s.
  const double nearest = std::round(period);
  const double tolerance = 4.0 * std::numeric_limits<double>::epsilon() * period;
  const double cut = std::abs(period - nearest) <= tolerance ? nearest : std::floor(period);
  return Duration(static_cast<Duration::rep>(cut));
}

std::optional<double> usualRate(const std::vector<Stamp>& stamps) {
  std::vector<Duration> gaps;
  for (std::size_t i = 1; i < stamps.size(); ++i) gaps.push_back(stamps[i] - stamps[i - 1]);
  if (gaps.empty()) return std::nullopt;
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::nth_element(gaps.begin(), middle, gaps.end());
  return 1.0 / toSeconds(*middle);
}

}  // namespace synthetic_dataset::motion
