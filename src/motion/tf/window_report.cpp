#include "motion/tf/window_report.h"

#include <algorithm>
#include <cstddef>
#include <set>

#include "motion/bag/ros_time.h"
#include "motion/frame_names.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::motion {
namespace {

constexpr std::size_t kMostNames = 12;
constexpr std::size_t kMostTimes = 3;

std::string existingFrames(const FrameTree& tree) {
  std::vector<std::string> names = tree.names().all();
  std::sort(names.begin(), names.end());
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), kMostNames); ++i) {
    list += (i == 0 ? "" : ", ") + names[i];
  }
  if (names.size() > kMostNames) {
    list += " and " + std::to_string(names.size() - kMostNames) + " more";
  }
  return list;
}

std::string unknownFrame(const FrameTree& tree, const std::string& role, const std::string& name) {
  const std::string guess = didYouMeanFrame(name, tree.names().all());
  return role + " '" + name + "' is not in the recording" +
         (guess.empty() ? "; its frames are " + existingFrames(tree) : guess);
}

/// The root of the tree to which `frame` belonged last.
std::string topOf(const FrameTree& tree, FrameId frame) {
  std::set<FrameId> seen;  // a recording can hold loops
  while (seen.insert(frame).second) {
    const std::vector<FrameId> parents = tree.link(frame).parents();
    if (!parents.empty()) frame = parents.back();
  }
  return tree.names().of(frame);
}

/// "; `global_frame: odom` takes ...": if all other frames hang below a single one.
std::string otherGlobalFrame(const FrameTree& tree, const std::vector<std::string>& frames) {
  std::set<std::string> tops;
  for (const std::string& frame : frames) {
    const auto id = tree.names().find(frame);
    if (id) tops.insert(topOf(tree, *id));
  }
  if (tops.size() != 1) return "";
  return "; nothing says where it is, and the other frames are known in '" + *tops.begin() +
         "': `global_frame: " + *tops.begin() + "` makes that the world's frame";
}

std::string relativeText(Stamp time, Stamp start) {
  constexpr int kDecimals = 3;
  return fixed(toSeconds(time - start), kDecimals) + " s";
}

std::string timesText(const Validity& times, Stamp start) {
  const bool has_start = times.from != Stamp::min();
  const bool has_end = times.until != Stamp::max();
  if (!has_start && !has_end) return "at all times";
  std::string exact;
  std::string relative;
  if (has_start) {
    exact += "from " + secondsText(times.from);
    relative += relativeText(times.from, start);
  }
  if (has_end) {
    exact += (has_start ? " to " : "to ") + secondsText(times.until);
    relative += (has_start ? " to " : "up to ") + relativeText(times.until, start);
  } else {
    exact += " on";
    relative += " on";
  }
  return exact + " (" + relative + " after the recording's start)";
}

/// The total length of the given times within a part.
Duration lengthIn(const RecordedTimes& part, const std::vector<Validity>& times) {
  Duration length{0};
  for (const Validity& each : times) {
    const Stamp from = std::max(each.from, part.start);
    length += std::max(Duration{0}, std::min(each.until, part.end) - from);
  }
  return length;
}

/// The times at which a frame has a parent.
std::vector<Validity> linkedTimes(const LinkHistory& link) {
  std::vector<Validity> times;
  for (Stamp time = Stamp::min();;) {
    const LinkHistory::Parent parent = link.parentAt(time);
    if (parent.frame != kNoFrame) times.push_back(parent.validity);
    if (parent.validity.until == Stamp::max()) return times;
    time = parent.validity.until + Duration{1};
  }
}

/// "TF has 'odom' in 'map' from 1.000 s to 3.000 s": of the links that lead to a frame, the one
/// that is known for the shortest time.
std::string linkToBlame(const FrameTree& tree, FrameId global, FrameId frame, Stamp known,
                        const RecordedTimes& part) {
  std::string text;
  Duration shortest = Duration::max();
  for (const FrameId child : tree.connection(global, frame, known).links) {
    const std::vector<Validity> times = linkedTimes(tree.link(child));
    const Duration length = lengthIn(part, times);
    if (length >= shortest) continue;
    shortest = length;
    text = "TF has '" + tree.names().of(child) + "' in '" +
           tree.names().of(tree.link(child).parentAt(known).frame) + "' " +
           stretchesText(times, part.start);
  }
  return text;
}

std::string whenKnown(const FrameTree& tree, FrameId global, FrameId frame,
                      const RecordedTimes& recorded) {
  const std::string names = "frame '" + tree.names().of(frame) + "' can be transformed into '" +
                            tree.names().of(global) + "' ";
  const std::vector<Validity> times = tree.knownTimes(global, frame);
  if (times.empty()) {
    const std::string reason =
        tree.everLinked(global, frame)
            ? "the transforms between them are never all known at the same time"
            : "nothing connects them: '" + tree.names().of(frame) + "' is in the tree of '" +
                  topOf(tree, frame) + "', '" + tree.names().of(global) + "' in that of '" +
                  topOf(tree, global) + "'";
    return names + "at no time: " + reason;
  }
  const std::string list = stretchesText(times, recorded.start);
  const bool outside = times.back().until < recorded.start || times.front().from > recorded.end;
  return names + list +
         (outside ? ": its time stamps lie outside the recording; was it recorded with another "
                    "clock (use_sim_time)?"
                  : "");
}

}  // namespace

std::vector<std::string> unknownFrames(const FrameTree& tree, const std::string& global_frame,
                                       const std::vector<std::string>& frames) {
  std::vector<std::string> messages;
  if (!tree.names().find(global_frame)) {
    messages.push_back(unknownFrame(tree, "global frame", global_frame) +
                       otherGlobalFrame(tree, frames));
  }
  for (const std::string& frame : frames) {
    if (!tree.names().find(frame)) messages.push_back(unknownFrame(tree, "frame", frame));
  }
  return messages;
}

std::string stretchesText(const std::vector<Validity>& times, Stamp start) {
  std::string list;
  for (std::size_t i = 0; i < std::min(times.size(), kMostTimes); ++i) {
    list += (i == 0 ? "" : ", ") + timesText(times[i], start);
  }
  if (times.size() > kMostTimes) {
    list += ", and in " + std::to_string(times.size() - kMostTimes) + " more stretches up to " +
            secondsText(times.back().until);
  }
  return list;
}

std::vector<FrameCost> frameCosts(const FrameTree& tree, const FramesToKnow& wanted,
                                  const RecordedTimes& part) {
  std::vector<FrameCost> costs;
  for (const FrameId frame : wanted.frames) {
    const std::vector<Validity> times = tree.knownTimes(wanted.global_frame, frame);
    const Duration unknown = part.end - part.start - lengthIn(part, times);
    if (times.empty() || unknown <= Duration{0}) continue;
    costs.push_back({tree.names().of(frame), unknown,
                     linkToBlame(tree, wanted.global_frame, frame, times.front().from, part)});
  }
  return costs;
}

std::vector<std::string> whyNoWindow(const FrameTree& tree, const FramesToKnow& wanted,
                                     const RecordedTimes& recorded, const RecordedTimes& part,
                                     const TimelineOptions& options) {
  std::vector<std::string> messages{
      "there is no stretch of time between " + secondsText(part.start) + " and " +
      secondsText(part.end) + " in which all frames can be transformed into '" +
      tree.names().of(wanted.global_frame) + "' (looked for in steps of " +
      secondsText(options.period) + ")"};
  for (const FrameId frame : wanted.frames) {
    messages.push_back(whenKnown(tree, wanted.global_frame, frame, recorded));
  }
  return messages;
}

}  // namespace synthetic_dataset::motion
