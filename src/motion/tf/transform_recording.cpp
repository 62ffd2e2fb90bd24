#include "motion/tf/transform_recording.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "motion/bag/ros_time.h"
#include "motion/frame_names.h"
#include "motion/tf/stretches.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

using Sample = LinkHistory::Sample;

template <class Item>
std::vector<Item> inOrder(const std::vector<Item>& items, const std::vector<std::size_t>& order) {
  std::vector<Item> sorted;
  sorted.reserve(order.size());
  for (const std::size_t i : order) sorted.push_back(items[i]);
  return sorted;
}

template <class Before>
std::vector<std::size_t> orderOf(std::size_t count, const Before& before) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  // Stable: among equals, what was recorded first stays first.
  std::stable_sort(order.begin(), order.end(), before);
  return order;
}

}  // namespace

void TransformRecording::add(RecordedTransform added) {
  geometry_msgs::TransformStamped& transform = added.transform;
  std::string& parent_name = transform.header.frame_id;
  std::string& child_name = transform.child_frame_id;
  parent_name = withoutLeadingSlashes(parent_name);
  child_name = withoutLeadingSlashes(child_name);
  const TransformKind own_kind = added.kind;
  const auto before = tree_.names().find(child_name);
  const auto history_before = before ? history_of_.find(*before) : history_of_.end();
  if (history_before != history_of_.end()) added.kind = histories_[history_before->second].kind;

  const Stamp stamp = toStamp(transform.header.stamp);
  bags_.try_emplace(added.arrival.bag, added.bag_file);
  // Whether stamps of zero are usable is only known at the end.
  const TransformKind judged = stamp == Stamp{0} ? TransformKind::kStatic : added.kind;
  if (const auto reason = reasonToLeaveOut(transform, judged)) {
    left_out_.add(added.bag_file, parent_name, child_name, *reason, stamp);
    return;
  }
  const FrameId parent = tree_.findOrAdd(parent_name);
  const FrameId child = tree_.findOrAdd(child_name);
  const auto [entry, is_new] = history_of_.try_emplace(child, histories_.size());
  if (is_new) histories_.push_back({child, added.kind, {}, {}});
  History& history = histories_[entry->second];
  if (history.kind == TransformKind::kStatic && own_kind != history.kind) history.is_moved = true;
  // A repeated static transform adds nothing.
  const bool is_repeated = history.kind == TransformKind::kStatic && !history.samples.empty() &&
                           history.samples.back().parent == parent &&
                           isSameTransform(history.samples.back().X_PC, transform.transform);
  if (is_repeated) return;
  if (continuesRun(history, {stamp, parent, transform.transform}, added.recorded)) {
    history.sources.back() = {added.recorded, added.arrival, publisherOf(added.publisher)};
    return;
  }
  history.samples.push_back({stamp, parent, transform.transform});
  history.sources.push_back({added.recorded, added.arrival, publisherOf(added.publisher)});
}

/// Whether a transform continues a run of equal values, of which only the first and the last are
/// kept: messages without stamps, such as gazebo_msgs/LinkStates, contain a whole world at 1000 Hz,
/// most of which stands still.
bool TransformRecording::continuesRun(const History& history, const Sample& next, Stamp recorded) {
  const std::vector<Sample>& samples = history.samples;
  const std::size_t count = samples.size();
  if (next.stamp != Stamp{0} || count < 2) return false;
  const std::vector<Source>& sources = history.sources;
  const bool goes_on = sources[count - 2].recorded < sources[count - 1].recorded &&
                       sources[count - 1].recorded < recorded;
  if (!goes_on) return false;  // for example in a simulation's clock
  const auto isSame = [&](const Sample& each) {
    return each.stamp == next.stamp && each.parent == next.parent && each.X_PC == next.X_PC;
  };
  return isSame(samples[count - 1]) && isSame(samples[count - 2]);
}

bool TransformRecording::moves(const std::string& frame) const {
  const auto id = tree_.names().find(frame);
  return id && history_of_.count(*id) != 0;
}

std::set<std::string> TransformRecording::connectedWith(const std::string& frame) const {
  std::set<std::string> names{withoutLeadingSlashes(frame)};
  const auto start = tree_.names().find(frame);
  if (!start) return names;
  std::map<FrameId, std::set<FrameId>> neighbours;
  for (const History& history : histories_) {
    for (const Sample& sample : history.samples) {
      if (!neighbours[history.child].insert(sample.parent).second) continue;
      neighbours[sample.parent].insert(history.child);
    }
  }
  std::set<FrameId> reached;
  std::vector<FrameId> next{*start};
  while (!next.empty()) {
    const FrameId here = next.back();
    next.pop_back();
    if (!reached.insert(here).second) continue;
    names.insert(tree_.names().of(here));
    next.insert(next.end(), neighbours[here].begin(), neighbours[here].end());
  }
  return names;
}

std::size_t TransformRecording::publisherOf(const std::string& name) {
  const auto known = std::find(publishers_.begin(), publishers_.end(), name);
  if (known == publishers_.end()) publishers_.push_back(name);
  return static_cast<std::size_t>(std::find(publishers_.begin(), publishers_.end(), name) -
                                  publishers_.begin());
}

FrameTree TransformRecording::finish(std::optional<std::size_t> stretch) {
  clock_offset_ = medianOffset();
  finishStampsOfZero();
  cut(stretch);
  clock_offset_ = medianOffset();
  checkSpans();
  for (History& history : histories_) {
    if (!history.samples.empty()) link(history);
  }
  return std::move(tree_);
}

Duration TransformRecording::medianOffset() const {
  std::vector<Duration> offsets;
  for (const History& history : histories_) {
    if (history.kind == TransformKind::kStatic) continue;
    for (std::size_t i = 0; i < history.samples.size(); ++i) {
      if (history.samples[i].stamp == Stamp{0}) continue;
      offsets.push_back(history.sources[i].recorded - history.samples[i].stamp);
    }
  }
  if (offsets.empty()) return Duration{0};
  const auto middle = offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
  std::nth_element(offsets.begin(), middle, offsets.end());
  return *middle;
}

/// If all stamps of a frame are zero, replaces them by the record times, in the clock of the other
/// stamps.
void TransformRecording::finishStampsOfZero() {
  const bool other_clock = clock_offset_ >= kSameClock || clock_offset_ <= -kSameClock;
  const Duration offset = other_clock ? clock_offset_ : Duration{0};
  for (History& history : histories_) {
    if (history.kind == TransformKind::kStatic) continue;
    std::vector<std::size_t> stamped;
    for (std::size_t i = 0; i < history.samples.size(); ++i) {
      if (history.samples[i].stamp != Stamp{0}) stamped.push_back(i);
    }
    if (stamped.size() == history.samples.size()) continue;
    if (stamped.empty()) {
      for (std::size_t i = 0; i < history.samples.size(); ++i) {
        history.samples[i].stamp = std::max(history.sources[i].recorded - offset, Stamp{1});
      }
      find(FrameFinding{history.child, "the transforms of the frame '" +
                                           tree_.names().of(history.child) +
                                           "' have time stamps of zero: their record times are "
                                           "taken instead"});
      continue;
    }
    for (std::size_t i = 0; i < history.samples.size(); ++i) {
      if (history.samples[i].stamp != Stamp{0}) continue;
      left_out_.add(bags_.at(history.sources[i].arrival.bag),
                    tree_.names().of(history.samples[i].parent), tree_.names().of(history.child),
                    "the time stamp is zero or out of range", Stamp{0});
    }
    history.samples = inOrder(history.samples, stamped);
    history.sources = inOrder(history.sources, stamped);
  }
}

void TransformRecording::cut(std::optional<std::size_t> stretch) {
  std::vector<std::vector<ArrivedStamp>> frames(histories_.size());
  for (std::size_t k = 0; k < histories_.size(); ++k) {
    const History& history = histories_[k];
    if (history.kind == TransformKind::kStatic) continue;
    const auto order = orderOf(history.samples.size(), [&](std::size_t a, std::size_t b) {
      return history.sources[a].arrival < history.sources[b].arrival;
    });
    std::unordered_map<std::int64_t, const Sample*> seen;
    for (const std::size_t i : order) {
      const Sample& sample = history.samples[i];
      const auto [first, is_new] = seen.try_emplace(sample.stamp.count(), &sample);
      if (!is_new && isSameTransform(first->second->X_PC, sample.X_PC)) continue;
      frames[k].push_back({sample.stamp, history.sources[i].arrival});
    }
  }
  const Cuts cuts = findCuts(frames);
  for (const auto& [k, steps] : cuts.alone) dropMixedTimes(histories_[k], steps);
  findStretches(cuts);
  if (stretch && *stretch >= stretches_.size()) {
    throw ErrorList({"stretch: found " + std::to_string(*stretch) +
                     "; time does not go back that often in the recording; its stretches are " +
                     stretchList(stretches_)});
  }
  stretch_ = stretch.value_or(longestOf(stretches_));
  if (cuts.all.empty()) return;
  for (std::size_t k = 0; k < histories_.size(); ++k) {
    if (histories_[k].kind == TransformKind::kStatic) {
      keepStatic(cuts, histories_[k]);
    } else {
      keepMoving(cuts, k);
    }
  }
}

void TransformRecording::dropMixedTimes(History& history, const std::vector<Arrival>& steps) {
  std::vector<TimedTransform> transforms;
  for (std::size_t i = 0; i < history.samples.size(); ++i) {
    const Source& source = history.sources[i];
    transforms.push_back({history.samples[i].stamp, source.recorded, source.arrival});
  }
  const std::vector<std::size_t> kept = withoutMixedTimes(transforms, steps, clock_offset_);
  const auto first = std::find_if(transforms.begin(), transforms.end(), [&](const auto& each) {
    return !(each.arrival < steps.front());
  });
  find(FrameFinding{
      history.child,
      "the time stamps of the frame '" + tree_.names().of(history.child) +
          "' go back while those of the other frames go on" +
          (steps.size() == 1 ? "" : ", " + std::to_string(steps.size()) + " times, first") +
          ", to " + secondsText(first->stamp) + "; of its " + std::to_string(transforms.size()) +
          " transforms, " + std::to_string(transforms.size() - kept.size()) +
          " are left out, so that poses from before and after are not mixed"});
  history.samples = inOrder(history.samples, kept);
  history.sources = inOrder(history.sources, kept);
}

void TransformRecording::findStretches(const Cuts& cuts) {
  stretches_.assign(cuts.all.size() + 1, {Stamp::max(), Stamp::min()});
  for (std::size_t k = 0; k < histories_.size(); ++k) {
    const History& history = histories_[k];
    if (history.kind == TransformKind::kStatic) continue;
    for (std::size_t i = 0; i < history.samples.size(); ++i) {
      Stretch& stretch = stretches_[cuts.stretchOf(k, history.sources[i].arrival)];
      stretch.first = std::min(stretch.first, history.samples[i].stamp);
      stretch.last = std::max(stretch.last, history.samples[i].stamp);
    }
  }
  for (Stretch& each : stretches_) {
    if (each.first > each.last) each = {};  // only static transforms
  }
}

void TransformRecording::keepMoving(const Cuts& cuts, std::size_t index) {
  History& history = histories_[index];
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < history.samples.size(); ++i) {
    if (cuts.stretchOf(index, history.sources[i].arrival) == stretch_) kept.push_back(i);
  }
  history.samples = inOrder(history.samples, kept);
  history.sources = inOrder(history.sources, kept);
}

/// The last value of earlier stretches still holds; values of later stretches do not hold yet.
void TransformRecording::keepStatic(const Cuts& cuts, History& history) {
  std::vector<std::size_t> kept;
  std::optional<std::size_t> before;
  std::optional<std::size_t> later;
  for (std::size_t i = 0; i < history.samples.size(); ++i) {
    const Arrival& arrival = history.sources[i].arrival;
    const auto stretch = static_cast<std::size_t>(
        std::upper_bound(cuts.all.begin(), cuts.all.end(), arrival) - cuts.all.begin());
    if (stretch < stretch_) before = i;
    if (stretch == stretch_) kept.push_back(i);
    if (stretch > stretch_ && !later) later = i;
  }
  if (before) {
    history.samples[*before].stamp = Stamp{0};  // it already held when the stretch began
    kept.insert(kept.begin(), *before);
  }
  if (kept.empty()) kept.push_back(*later);
  history.samples = inOrder(history.samples, kept);
  history.sources = inOrder(history.sources, kept);
}

void TransformRecording::namePublishers(History& history) {
  std::set<std::string> names;
  for (const Source& source : history.sources) names.insert(publishers_[source.publisher]);
  names.erase("");
  history.publishers.assign(names.begin(), names.end());
}

void TransformRecording::link(History& history) {
  namePublishers(history);
  if (history.kind == TransformKind::kStatic) {
    timeStatic(history);
    find(findStaticChange(tree_.names(), history.child, history.samples, history.is_moved));
    tree_.setLink(history.child, LinkHistory::heldFrom(std::move(history.samples)));
    return;
  }
  sortByStamp(history);
  find(findFight(tree_.names(), history.child, history.samples, history.publishers));
  find(findParentChange(tree_.names(), history.child, history.samples));
  tree_.setLink(history.child, LinkHistory::sampledAt(std::move(history.samples)));
}

void TransformRecording::find(std::optional<FrameFinding> finding) {
  if (finding) findings_.push_back(*std::move(finding));
}

/// The stamps of static transforms may be anything: if one is not after the previous one, the
/// record time is used instead.
void TransformRecording::timeStatic(History& history) {
  std::vector<Sample>& samples = history.samples;
  if (!isRosTime(samples.front().stamp)) samples.front().stamp = Stamp{0};
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Stamp before = samples[i - 1].stamp;
    if (isRosTime(samples[i].stamp) && samples[i].stamp > before) continue;
    const bool other_clock = clock_offset_ >= kSameClock || clock_offset_ <= -kSameClock;
    const Stamp recorded =
        history.sources[i].recorded - (other_clock ? clock_offset_ : Duration{0});
    samples[i].stamp = std::max(recorded, before + Duration{1});
  }
}

void TransformRecording::sortByStamp(History& history) {
  const auto order = orderOf(history.samples.size(), [&](std::size_t a, std::size_t b) {
    return history.samples[a].stamp < history.samples[b].stamp;
  });
  std::vector<Sample> samples = inOrder(history.samples, order);
  std::size_t kept = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Sample& last = samples[kept];
    const Sample& next = samples[i];
    if (next.stamp != last.stamp) {
      samples[++kept] = next;
    } else if (next.parent != last.parent || next.X_PC != last.X_PC) {
      left_out_.add("", tree_.names().of(next.parent), tree_.names().of(history.child),
                    "an earlier one with other values has the same time stamp", next.stamp);
    }
  }
  samples.resize(kept + 1);
  history.samples = std::move(samples);
}

void TransformRecording::checkSpans() const {
  constexpr Duration kLongest = std::chrono::seconds(std::numeric_limits<std::int32_t>::max());
  std::vector<std::string> errors;
  for (const History& history : histories_) {
    if (history.kind == TransformKind::kStatic || history.samples.empty()) continue;
    const auto [first, last] =
        std::minmax_element(history.samples.begin(), history.samples.end(),
                            [](const Sample& a, const Sample& b) { return a.stamp < b.stamp; });
    if (last->stamp - first->stamp <= kLongest) continue;  // ros::Duration holds 68 years
    errors.push_back("the time stamps of frame '" + tree_.names().of(history.child) + "' go from " +
                     secondsText(first->stamp) + " to " + secondsText(last->stamp) +
                     ": more than ROS can hold; one of them must be wrong");
  }
  if (!errors.empty()) throw ErrorList(errors);
}

}  // namespace synthetic_dataset::motion
