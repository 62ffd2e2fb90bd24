#include "motion/timeline_search.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "base/diagnostics.h"
#include "motion/bag/ros_time.h"
#include "motion/tf/frame_tree.h"
#include "motion/timeline.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::motion {
namespace {

/// Long gaps in a recording, and the scenes that fall into them.
class Holes {
 public:
  /// @param tree, options  have to outlive this
  Holes(const FrameTree& tree, const TimelineOptions& options) : tree_(tree), options_(options) {}

  /// Whether a scene at this time is forbidden, because poses would be interpolated across a hole.
  /// If the pose is the same at both ends of the hole, it is allowed. Counts the scene.
  /// @param links  that are crossed at that time
  [[nodiscard]] bool forbid(const std::set<FrameId>& links, Stamp time);

  /// Reports the holes into which scenes fell, with their times.
  void report(base::Diagnostics& diagnostics) const;

 private:
  struct Hole {
    Gap gap;
    bool is_forbidden = false;
    std::int64_t scenes = 0;
  };

  [[nodiscard]] std::string message(FrameId child, const Hole& hole) const;

  const FrameTree& tree_;
  const TimelineOptions& options_;
  std::map<std::pair<FrameId, Stamp>, Hole> holes_;  ///< by frame and start
};

std::string scenesText(std::int64_t count) {
  return std::to_string(count) + (count == 1 ? " scene" : " scenes");
}

std::string secondsOf(Duration time) {
  constexpr int kDecimals = 3;
  return fixed(toSeconds(time), kDecimals) + " s";
}

/// The longest gap in a frame's transforms that is not a hole: the larger of 10 s and 20 median
/// periods.
Duration longestGapOf(const LinkHistory& link) {
  constexpr Duration kLeast = std::chrono::seconds(10);
  constexpr int kPeriods = 20;
  return std::max(kLeast, kPeriods * link.medianPeriod());
}

bool isTooLong(const Gap& gap, Duration usual, const std::optional<Duration>& max_tf_gap) {
  return gap.length() > max_tf_gap.value_or(usual) && !gap.is_still;
}

bool Holes::forbid(const std::set<FrameId>& links, Stamp time) {
  bool is_forbidden = false;
  for (const FrameId child : links) {
    const LinkHistory& link = tree_.link(child);
    const auto gap = link.gapAt(time);
    if (!gap) continue;
    const Duration usual = longestGapOf(link);
    const Duration longest = options_.max_tf_gap.value_or(usual);
    if (gap->length() <= std::min(longest, usual)) continue;
    Hole& hole = holes_.try_emplace({child, gap->from}, Hole{*gap}).first->second;
    hole.is_forbidden = isTooLong(*gap, usual, options_.max_tf_gap);
    ++hole.scenes;
    is_forbidden = is_forbidden || hole.is_forbidden;
  }
  return is_forbidden;
}

std::string Holes::message(FrameId child, const Hole& hole) const {
  std::string text = "TF has no data for the frame '" + tree_.names().of(child) + "' from " +
                     secondsOf(hole.gap.from) + " to " + secondsOf(hole.gap.until) + " (" +
                     secondsOf(hole.gap.length()) + "): " + scenesText(hole.scenes) +
                     " in between ";
  const std::string verb = hole.scenes == 1 ? "is " : "are ";
  if (hole.is_forbidden) {
    return text + verb + "left out (max_tf_gap: .inf makes " + (hole.scenes == 1 ? "it" : "them") +
           ")";
  }
  if (hole.gap.is_still) return text + verb + "made, as its pose is the same before and after";
  return text + verb + "made, its poses interpolated across, as max_tf_gap allows";
}

void Holes::report(base::Diagnostics& diagnostics) const {
  constexpr std::int64_t kMost = 5;  // per frame
  std::map<FrameId, std::int64_t> counts;
  std::map<FrameId, std::int64_t> scenes_of_others;
  for (const auto& [place, hole] : holes_) {
    if (++counts[place.first] <= kMost) {
      diagnostics.warning("", message(place.first, hole));
    } else {
      scenes_of_others[place.first] += hole.scenes;
    }
  }
  for (const auto& [child, scenes] : scenes_of_others) {
    diagnostics.warning("", "TF has " + std::to_string(counts[child] - kMost) +
                                " more such holes of the frame '" + tree_.names().of(child) +
                                "', with " + scenesText(scenes));
  }
}

constexpr Duration kTick{1};
constexpr std::int64_t kMostScenes = 100000000;  // file names have eight digits

/// Number of periods, including the last one begun.
std::int64_t periodsIn(Duration length, Duration period) {
  return (length + period - kTick) / period;
}

/// The wanted frames' connections with the global frame. For times that are close together, it
/// seldom has to climb the tree.
class Connections {
 public:
  Connections(const FrameTree& tree, const FramesToKnow& wanted) : tree_(tree), wanted_(wanted) {
    for (const FrameId frame : wanted.frames) {
      connections_.push_back(tree.connection(wanted.global_frame, frame, Stamp{0}));
    }
  }

  /// The connections of all wanted frames, in the frames' order.
  const std::vector<Connection>& at(Stamp time) {
    for (std::size_t i = 0; i < connections_.size(); ++i) {
      const Validity& validity = connections_[i].validity;
      if (time >= validity.from && time <= validity.until) continue;
      connections_[i] = tree_.connection(wanted_.global_frame, wanted_.frames[i], time);
    }
    return connections_;
  }

  bool allKnownAt(Stamp time) {
    const std::vector<Connection>& now = at(time);
    return std::all_of(now.begin(), now.end(), [](const Connection& c) { return c.known; });
  }

  /// The links that are crossed at that time.
  std::set<FrameId> linksAt(Stamp time) {
    std::set<FrameId> links;
    for (const Connection& connection : at(time)) {
      links.insert(connection.links.begin(), connection.links.end());
    }
    return links;
  }

 private:
  const FrameTree& tree_;
  const FramesToKnow& wanted_;
  std::vector<Connection> connections_;
};

/// The first of time, time + period, ... before `limit` at which all frames are known. Intervals in
/// which one of them stays unknown are skipped in one step.
std::optional<Stamp> firstKnown(Connections& connections, Stamp time, Stamp limit,
                                Duration period) {
  while (time < limit) {
    Stamp next = time;
    for (const Connection& connection : connections.at(time)) {
      if (connection.known) continue;
      if (connection.validity.until >= limit) return std::nullopt;
      next = std::max(next, connection.validity.until + kTick);
    }
    if (next == time) return time;
    time += periodsIn(next - time, period) * period;
  }
  return std::nullopt;
}

/// The same backwards: the first of time, time - period, ... after `limit`.
std::optional<Stamp> lastKnown(Connections& connections, Stamp time, Stamp limit, Duration period) {
  while (time > limit) {
    Stamp next = time;
    for (const Connection& connection : connections.at(time)) {
      if (connection.known) continue;
      if (connection.validity.from <= limit) return std::nullopt;
      next = std::min(next, connection.validity.from - kTick);
    }
    if (next == time) return time;
    time -= periodsIn(time - next, period) * period;
  }
  return std::nullopt;
}

/// Leaves out scenes at times at which something is not known, or that a hole forbids.
class TimeFilter {
 public:
  TimeFilter(const FrameTree& tree, Connections& connections, const TimelineOptions& options)
      : connections_(connections), holes_(tree, options) {}

  /// @return whether there is a scene at that time; if not, it is counted as left out
  [[nodiscard]] bool passes(Stamp time, Timeline& timeline) {
    if (!connections_.allKnownAt(time)) {
      ++timeline.left_out_unknown;
      return false;
    }
    if (holes_.forbid(connections_.linksAt(time), time)) {
      ++timeline.left_out_gap;
      return false;
    }
    return true;
  }

  void report(base::Diagnostics& diagnostics) const { holes_.report(diagnostics); }

 private:
  Connections& connections_;
  Holes holes_;
};

/// The timeline of the given times that lie in the part.
Timeline timelineOf(const std::vector<Stamp>& stamps, const RecordedTimes& part,
                    TimeFilter& filter) {
  Timeline timeline;
  for (const Stamp time : stamps) {
    const bool is_inside = time >= part.start && time <= part.end;
    if (is_inside && filter.passes(time, timeline)) timeline.stamps.push_back(time);
  }
  filter.report(timeline.diagnostics);
  return timeline;
}

void checkCount(std::int64_t scenes, Duration period) {
  if (scenes <= kMostScenes) return;
  throw ErrorList({"one scene every " + secondsText(period) + " makes " + std::to_string(scenes) +
                   " scenes; at most " + std::to_string(kMostScenes) +
                   " can be numbered: lower the rate or the duration"});
}

}  // namespace

std::optional<RecordedTimes> knownTimes(const FrameTree& tree, const FramesToKnow& wanted,
                                        const RecordedTimes& part) {
  Connections connections(tree, wanted);
  const auto first = firstKnown(connections, part.start, part.end + kTick, kTick);
  if (!first) return std::nullopt;
  const auto last = lastKnown(connections, part.end, *first - kTick, kTick);
  return RecordedTimes{*first, last.value_or(*first)};
}

bool isForbidden(const LinkHistory& link, Stamp time, const std::optional<Duration>& max_tf_gap) {
  const auto gap = link.gapAt(time);
  return gap && isTooLong(*gap, longestGapOf(link), max_tf_gap);
}

std::vector<std::string> optionErrors(const RecordedTimes& recorded,
                                      const TimelineOptions& options) {
  const Duration length = recorded.end - recorded.start;
  const std::string lasts = "; the recording lasts " + secondsText(length);
  std::vector<std::string> errors;
  if (options.period <= Duration{0}) {
    errors.push_back("the period is " + secondsText(options.period) + "; it has to be above 0");
  }
  if (options.start_offset < Duration{0} || options.start_offset >= length) {
    errors.push_back("the start offset of " + secondsText(options.start_offset) +
                     " leaves nothing of the recording" + lasts);
  }
  if (options.duration && *options.duration <= Duration{0}) {
    errors.push_back("the duration is " + secondsText(*options.duration) +
                     "; it has to be above 0" + lasts);
  }
  return errors;
}

RecordedTimes usedPart(const RecordedTimes& recorded, const TimelineOptions& options) {
  const Stamp start = recorded.start + options.start_offset;
  const Duration rest = recorded.end - start;
  return {start, start + std::min(rest, options.duration.value_or(rest))};
}

std::optional<Timeline> findTimeline(const FrameTree& tree, const FramesToKnow& wanted,
                                     const RecordedTimes& part, const TimelineOptions& options) {
  const Duration period = options.period;
  Connections connections(tree, wanted);
  TimeFilter filter(tree, connections, options);
  if (options.stamps) return timelineOf(*options.stamps, part, filter);
  const auto start = firstKnown(connections, part.start, part.end, period);
  if (!start) return std::nullopt;
  const auto end = lastKnown(connections, part.end, *start, period);
  if (!end) return std::nullopt;

  const std::int64_t scenes = periodsIn(*end - *start, period);
  checkCount(scenes, period);
  Timeline timeline;
  timeline.stamps.reserve(static_cast<std::size_t>(scenes));
  const std::int64_t first = (*start - part.start) / period;
  for (std::int64_t i = 0; i < scenes; ++i) {
    const Duration jitter = options.jitter ? options.jitter(first + i) : Duration{0};
    const Stamp time = *start + i * period + jitter;
    if (!filter.passes(time, timeline)) continue;
    timeline.stamps.push_back(time);
    if (options.jitter) timeline.jitter.push_back(jitter);
  }
  filter.report(timeline.diagnostics);
  return timeline;
}

}  // namespace synthetic_dataset::motion
