#include "motion/tf/lone_steps.h"

#include <algorithm>
#include <chrono>

namespace synthetic_dataset::motion {
namespace {

/// What lies between two steps back.
struct Part {
  std::vector<std::size_t> transforms;
  Duration clock_error{0};  ///< how far its stamps are from the recording's clock
  bool counts = false;
};

Duration absolute(Duration duration) { return duration < Duration{0} ? -duration : duration; }

std::vector<Part> partsOf(const std::vector<TimedTransform>& transforms,
                          const std::vector<Arrival>& steps, Duration clock_offset) {
  std::vector<Part> parts(steps.size() + 1);
  for (std::size_t i = 0; i < transforms.size(); ++i) {
    const auto step = std::upper_bound(steps.begin(), steps.end(), transforms[i].arrival);
    parts[static_cast<std::size_t>(step - steps.begin())].transforms.push_back(i);
  }
  const auto isEmpty = [](const Part& part) { return part.transforms.empty(); };
  parts.erase(std::remove_if(parts.begin(), parts.end(), isEmpty), parts.end());
  for (Part& part : parts) {
    std::vector<Duration> offsets;
    for (const std::size_t i : part.transforms) {
      offsets.push_back(transforms[i].recorded - transforms[i].stamp);
    }
    const auto middle = offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
    std::nth_element(offsets.begin(), middle, offsets.end());
    part.clock_error = absolute(*middle - clock_offset);
    part.counts = part.clock_error < kSameClock;
  }
  return parts;
}

}  // namespace

std::vector<std::size_t> withoutMixedTimes(const std::vector<TimedTransform>& transforms,
                                           const std::vector<Arrival>& steps,
                                           Duration clock_offset) {
  std::vector<Part> parts = partsOf(transforms, steps, clock_offset);
  const auto counts = [](const Part& part) { return part.counts; };
  if (std::none_of(parts.begin(), parts.end(), counts) && !parts.empty()) {
    std::min_element(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
      return a.clock_error < b.clock_error;
    })->counts = true;
  }
  std::vector<std::size_t> kept;
  Stamp end = Stamp::max();  // the first stamp of the parts after it
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    if (!part->counts) continue;
    Stamp first = end;
    for (const std::size_t i : part->transforms) {
      if (transforms[i].stamp >= end) continue;
      first = std::min(first, transforms[i].stamp);
      kept.push_back(i);
    }
    end = first;
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

}  // namespace synthetic_dataset::motion
