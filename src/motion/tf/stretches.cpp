#include "motion/tf/stretches.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>
#include <utility>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::motion {
namespace {

using Stamps = std::vector<ArrivedStamp>;

/// Shorter steps back come from messages that overtook one another.
constexpr Duration kLeastStepBack = std::chrono::milliseconds(100);
/// This many transforms have to follow a step back, all with stamps from before it.
constexpr std::size_t kLeastToFollow = 3;
/// If stamps have not returned after this many transforms, they never do.
constexpr std::size_t kMostToFollow = 1000;
/// A frame whose stamps returned more often has several publishers, and says nothing about the
/// clock.
constexpr std::size_t kMostReturns = 3;

Duration medianPeriod(const Stamps& stamps) {
  std::vector<Duration> periods;
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    const Duration period = stamps[i].stamp - stamps[i - 1].stamp;
    if (period > Duration{0}) periods.push_back(period);
  }
  if (periods.empty()) return Duration{0};
  const auto middle = periods.begin() + static_cast<std::ptrdiff_t>(periods.size() / 2);
  std::nth_element(periods.begin(), middle, periods.end());
  return *middle;
}

/// How stamps continue after a step back.
struct AfterStepBack {
  bool returns = false;
  std::size_t next = 0;  ///< where to continue the search
};

/// @param latest  the stamp from which it steps back to the transform `at`
AfterStepBack follow(const Stamps& stamps, std::size_t at, Stamp latest) {
  const std::size_t end = std::min(stamps.size(), at + kMostToFollow);
  std::size_t i = at + 1;
  while (i < end && stamps[i].stamp < latest) ++i;
  const bool passes = i < end;
  const bool leaps =
      passes && stamps[i].stamp - stamps[i - 1].stamp >= (latest - stamps[at].stamp) / 2;
  if (leaps || (!passes && i - at < kLeastToFollow)) return {true, i};
  return {false, at + 1};
}

/// The transforms at which one frame's stamps drop and go on from there.
std::vector<Arrival> stepsBack(const Stamps& stamps) {
  std::vector<Arrival> steps;
  if (stamps.empty()) return steps;
  const Duration period = medianPeriod(stamps);
  std::size_t returns = 0;
  Stamp latest = stamps.front().stamp;
  for (std::size_t i = 1; i < stamps.size();) {
    const Duration back = latest - stamps[i].stamp;
    if (back < kLeastStepBack || back / 3 < period) {
      latest = std::max(latest, stamps[i].stamp);
      ++i;
      continue;
    }
    const AfterStepBack after = follow(stamps, i, latest);
    if (after.returns) {
      ++returns;
    } else {
      steps.push_back(stamps[i].arrival);
      latest = stamps[i].stamp;
    }
    i = after.next;
  }
  return returns > kMostReturns ? std::vector<Arrival>{} : steps;
}

struct Step {
  Arrival arrival;
  std::size_t frame;
};

/// Groups steps of different frames that belong together: the next step of a frame that is already
/// in a group begins another group.
std::vector<std::vector<Step>> grouped(std::vector<Step> steps) {
  std::stable_sort(steps.begin(), steps.end(),
                   [](const Step& a, const Step& b) { return a.arrival < b.arrival; });
  std::vector<std::vector<Step>> groups;
  std::set<std::size_t> frames;
  for (const Step& step : steps) {
    if (groups.empty() || !frames.insert(step.frame).second) {
      groups.emplace_back();
      frames = {step.frame};
    }
    groups.back().push_back(step);
  }
  return groups;
}

/// Whether a frame has transforms before and after an arrival.
bool spans(const Stamps& stamps, const Arrival& arrival) {
  if (stamps.empty() || !(stamps.front().arrival < arrival)) return false;
  const auto after = std::count_if(stamps.begin(), stamps.end(), [&](const ArrivedStamp& each) {
    return !(each.arrival < arrival);
  });
  return static_cast<std::size_t>(after) >= kLeastToFollow;
}

/// The transforms between two steps back.
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

std::size_t Cuts::stretchOf(std::size_t frame, const Arrival& arrival) const {
  const std::vector<Arrival>& cuts = of_frames[frame];
  return static_cast<std::size_t>(std::upper_bound(cuts.begin(), cuts.end(), arrival) -
                                  cuts.begin());
}

Cuts findCuts(const std::vector<Stamps>& frames) {
  std::vector<Step> steps;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    for (const Arrival& arrival : stepsBack(frames[i])) steps.push_back({arrival, i});
  }
  Cuts cuts;
  cuts.of_frames.resize(frames.size());
  for (const std::vector<Step>& group : grouped(std::move(steps))) {
    const Arrival& first = group.front().arrival;
    const auto voters = std::count_if(frames.begin(), frames.end(),
                                      [&](const Stamps& each) { return spans(each, first); });
    if (2 * group.size() < static_cast<std::size_t>(voters)) {
      for (const Step& step : group) cuts.alone[step.frame].push_back(step.arrival);
      continue;
    }
    cuts.all.push_back(first);
    for (std::vector<Arrival>& each : cuts.of_frames) each.push_back(first);
    for (const Step& step : group) cuts.of_frames[step.frame].back() = step.arrival;
  }
  return cuts;
}

std::string stretchList(const std::vector<Stretch>& stretches) {
  constexpr int kDecimals = 3;
  std::string list;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const Stretch& each = stretches[i];
    list += (i == 0 ? "" : ", ") + std::to_string(i) + ": " +
            fixed(toSeconds(each.first), kDecimals) + " s to " +
            fixed(toSeconds(each.last), kDecimals) + " s (" +
            fixed(toSeconds(each.last - each.first), kDecimals) + " s)";
  }
  return list;
}

std::size_t longestOf(const std::vector<Stretch>& stretches) {
  const auto longest = std::max_element(
      stretches.begin(), stretches.end(),
      [](const Stretch& a, const Stretch& b) { return a.last - a.first < b.last - b.first; });
  return static_cast<std::size_t>(longest - stretches.begin());
}

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
  Stamp end = Stamp::max();  // the first stamp of the parts after the current one
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
