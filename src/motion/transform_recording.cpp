#include "motion/transform_recording.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "motion/frame_names.h"
#include "motion/ros_time.h"
#include "motion/time_text.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {

void TransformRecording::add(geometry_msgs::TransformStamped transform, TransformKind kind,
                             const std::string& bag_file) {
  std::string& parent_name = transform.header.frame_id;
  std::string& child_name = transform.child_frame_id;
  parent_name = withoutLeadingSlashes(parent_name);
  child_name = withoutLeadingSlashes(child_name);
  const auto before = tree_.find(child_name);
  const auto history_before = before ? history_of_.find(*before) : history_of_.end();
  if (history_before != history_of_.end()) kind = histories_[history_before->second].kind;

  const Stamp stamp = toStamp(transform.header.stamp);
  if (const auto reason = reasonToLeaveOut(transform, kind)) {
    left_out_.add(bag_file, parent_name, child_name, *reason, stamp);
    return;
  }
  const FrameIndex parent = tree_.findOrAdd(parent_name);
  const FrameIndex child = tree_.findOrAdd(child_name);
  const auto [entry, is_new] = history_of_.try_emplace(child, histories_.size());
  if (is_new) histories_.push_back({child, kind, {}});
  std::vector<Sample>& samples = histories_[entry->second].samples;
  if (kind == TransformKind::kStatic) {  // its stamp means nothing and may be anything
    samples = {{Stamp{0}, parent, transform.transform}};
  } else {
    samples.push_back({stamp, parent, transform.transform});
  }
}

void TransformRecording::finish() {
  for (History& history : histories_) {
    if (history.kind == TransformKind::kStatic) {
      tree_.setLink(history.child, LinkHistory::fixedTo(history.samples.back().parent));
      continue;
    }
    sortByStamp(history);
    std::vector<LinkHistory::Sample> samples;
    samples.reserve(history.samples.size());
    for (const Sample& sample : history.samples) samples.push_back({sample.stamp, sample.parent});
    tree_.setLink(history.child, LinkHistory::sampledAt(samples));
  }
}

void TransformRecording::sortByStamp(History& history) {
  std::vector<Sample>& samples = history.samples;
  // Stable: what was recorded first stays first among equal stamps.
  std::stable_sort(samples.begin(), samples.end(),
                   [](const Sample& a, const Sample& b) { return a.stamp < b.stamp; });
  std::size_t kept = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Sample& last = samples[kept];
    const Sample& next = samples[i];
    if (next.stamp != last.stamp) {
      samples[++kept] = next;
    } else if (next.parent != last.parent || next.X_PC != last.X_PC) {
      left_out_.add("", tree_.name(next.parent), tree_.name(history.child),
                    "an earlier one with other values has the same time stamp", next.stamp);
    }
  }
  samples.resize(kept + 1);
}

ros::Duration TransformRecording::cacheTime() const {
  // tf2 adds the cache's length to stamps; ros::Time ends in 2106, ros::Duration at 68 years.
  constexpr Duration kLongestCache = std::chrono::seconds(std::numeric_limits<std::int32_t>::max());
  constexpr Duration kLatestSum = std::chrono::seconds(std::numeric_limits<std::uint32_t>::max());
  constexpr Duration kMargin = std::chrono::seconds(1);
  Duration cache = kMargin;
  Stamp latest{0};
  std::vector<std::string> errors;
  for (const History& history : histories_) {
    if (history.kind == TransformKind::kStatic) continue;
    const Stamp first = history.samples.front().stamp;
    const Stamp last = history.samples.back().stamp;
    cache = std::max(cache, last - first + kMargin);
    latest = std::max(latest, last);
    if (cache <= kLongestCache && latest + cache <= kLatestSum) continue;
    errors.push_back("the time stamps of frame '" + tree_.name(history.child) + "' go from " +
                     secondsText(first) + " to " + secondsText(last) +
                     ": more than tf2 can hold; one of them must be wrong");
    cache = kMargin;
    latest = Stamp{0};
  }
  if (!errors.empty()) throw ErrorList(errors);
  return toRosDuration(cache);
}

std::unique_ptr<tf2::BufferCore> TransformRecording::moveToBuffer() {
  auto buffer = std::make_unique<tf2::BufferCore>(cacheTime());
  geometry_msgs::TransformStamped transform;
  for (History& history : histories_) {
    transform.child_frame_id = tree_.name(history.child);
    for (const Sample& sample : std::exchange(history.samples, {})) {
      transform.header.stamp = toRosTime(sample.stamp);
      transform.header.frame_id = tree_.name(sample.parent);
      transform.transform = sample.X_PC;
      buffer->setTransform(transform, "bag", history.kind == TransformKind::kStatic);
    }
  }
  return buffer;
}

}  // namespace synthetic_dataset::motion
