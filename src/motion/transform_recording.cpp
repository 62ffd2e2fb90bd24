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
  const auto before = tree_.names().find(child_name);
  const auto history_before = before ? history_of_.find(*before) : history_of_.end();
  if (history_before != history_of_.end()) kind = histories_[history_before->second].kind;

  const Stamp stamp = toStamp(transform.header.stamp);
  if (const auto reason = reasonToLeaveOut(transform, kind)) {
    left_out_.add(bag_file, parent_name, child_name, *reason, stamp);
    return;
  }
  const FrameId parent = tree_.findOrAdd(parent_name);
  const FrameId child = tree_.findOrAdd(child_name);
  const auto [entry, is_new] = history_of_.try_emplace(child, histories_.size());
  if (is_new) histories_.push_back({child, kind, {}});
  auto& samples = histories_[entry->second].samples;
  if (kind == TransformKind::kStatic) {  // its stamp means nothing and may be anything
    samples = {{Stamp{0}, parent, transform.transform}};
  } else {
    samples.push_back({stamp, parent, transform.transform});
  }
}

FrameTree TransformRecording::finish() {
  for (History& history : histories_) {
    if (history.kind == TransformKind::kMoving) sortByStamp(history);
  }
  checkSpans();
  for (History& history : histories_) {
    const auto& last = history.samples.back();
    tree_.setLink(history.child, history.kind == TransformKind::kStatic
                                     ? LinkHistory::fixedTo(last.parent, last.X_PC)
                                     : LinkHistory::sampledAt(std::move(history.samples)));
  }
  return std::move(tree_);
}

void TransformRecording::sortByStamp(History& history) {
  using Sample = LinkHistory::Sample;
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
      left_out_.add("", tree_.names().of(next.parent), tree_.names().of(history.child),
                    "an earlier one with other values has the same time stamp", next.stamp);
    }
  }
  samples.resize(kept + 1);
}

void TransformRecording::checkSpans() const {
  constexpr Duration kLongest = std::chrono::seconds(std::numeric_limits<std::int32_t>::max());
  std::vector<std::string> errors;
  for (const History& history : histories_) {
    const Stamp first = history.samples.front().stamp;
    const Stamp last = history.samples.back().stamp;
    if (last - first <= kLongest) continue;  // what ros::Duration can hold, 68 years
    errors.push_back("the time stamps of frame '" + tree_.names().of(history.child) + "' go from " +
                     secondsText(first) + " to " + secondsText(last) +
                     ": more than ROS can hold; one of them must be wrong");
  }
  if (!errors.empty()) throw ErrorList(errors);
}

}  // namespace synthetic_dataset::motion
