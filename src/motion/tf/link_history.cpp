#include "motion/tf/link_history.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include <tf2/LinearMath/Quaternion.h>
#include <tf2/LinearMath/Vector3.h>

#include "motion/bag/ros_time.h"

namespace synthetic_dataset::motion {
namespace {

tf2::Vector3 positionOf(const LinkHistory::Sample& sample) {
  const auto& t = sample.X_PC.translation;
  return {t.x, t.y, t.z};
}

tf2::Quaternion rotationOf(const LinkHistory::Sample& sample) {
  const auto& q = sample.X_PC.rotation;
  return {q.x, q.y, q.z, q.w};
}

/// Uses tf2's own arithmetic, to give the same result as tf2::BufferCore. The only exception: if
/// both poses are equal, the result is exactly that pose, without the rounding of interpolation, so
/// that a picture from there can be reused.
geometry_msgs::Transform interpolated(const LinkHistory::Sample& before,
                                      const LinkHistory::Sample& after, Stamp time) {
  if (before.X_PC == after.X_PC) return before.X_PC;
  const double ratio = toRosDuration(time - before.stamp).toSec() /
                       toRosDuration(after.stamp - before.stamp).toSec();
  tf2::Vector3 position;
  position.setInterpolate3(positionOf(before), positionOf(after), ratio);
  const tf2::Quaternion rotation = tf2::slerp(rotationOf(before), rotationOf(after), ratio);
  geometry_msgs::Transform X_PC;
  X_PC.translation.x = position.x();
  X_PC.translation.y = position.y();
  X_PC.translation.z = position.z();
  X_PC.rotation.x = rotation.x();
  X_PC.rotation.y = rotation.y();
  X_PC.rotation.z = rotation.z();
  X_PC.rotation.w = rotation.w();
  return X_PC;
}

/// Whether two poses are the same, except for the noise of something that stands still.
bool isSamePose(const LinkHistory::Sample& a, const LinkHistory::Sample& b) {
  constexpr double kDistance = 1e-3;  // [m]
  constexpr double kAngle = 1e-3;     // [rad]
  return a.parent == b.parent && positionOf(a).distance(positionOf(b)) <= kDistance &&
         std::abs(rotationOf(a).angleShortestPath(rotationOf(b))) <= kAngle;
}

Duration medianPeriodOf(const std::vector<LinkHistory::Sample>& samples) {
  if (samples.size() < 2) return Duration{0};
  std::vector<Duration> periods;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    periods.push_back(samples[i].stamp - samples[i - 1].stamp);
  }
  const auto middle = periods.begin() + static_cast<std::ptrdiff_t>(periods.size() / 2);
  std::nth_element(periods.begin(), middle, periods.end());
  return *middle;
}

}  // namespace

void Validity::intersect(const Validity& other) {
  from = std::max(from, other.from);
  until = std::min(until, other.until);
}

LinkHistory LinkHistory::fixedTo(FrameId parent, const geometry_msgs::Transform& X_PC) {
  return heldFrom({{Stamp{0}, parent, X_PC}});
}

LinkHistory LinkHistory::heldFrom(std::vector<Sample> samples) {
  LinkHistory link = sampledAt(std::move(samples));
  link.is_held_ = true;
  return link;
}

LinkHistory LinkHistory::sampledAt(std::vector<Sample> samples) {
  LinkHistory link;
  for (const Sample& sample : samples) {
    const bool changed = link.changes_.empty() || link.changes_.back().parent != sample.parent;
    if (changed) link.changes_.push_back({sample.stamp, sample.parent});
  }
  link.samples_ = std::move(samples);
  link.median_period_ = medianPeriodOf(link.samples_);
  return link;
}

LinkHistory::Parent LinkHistory::parentAt(Stamp time) const {
  if (samples_.empty()) return {};
  constexpr Duration kTick{1};
  const Stamp first = samples_.front().stamp;
  const Stamp last = samples_.back().stamp;
  if (!is_held_ && time < first) return {kNoFrame, {Stamp::min(), first - kTick}};
  if (!is_held_ && time > last) return {kNoFrame, {last + kTick, Stamp::max()}};
  auto next = std::upper_bound(changes_.begin(), changes_.end(), time,
                               [](Stamp t, const Change& change) { return t < change.stamp; });
  if (next == changes_.begin()) ++next;  // the first one also holds before its time
  const Change& current = *std::prev(next);
  Validity validity{current.stamp, next == changes_.end() ? last : next->stamp - kTick};
  if (is_held_ && &current == &changes_.front()) validity.from = Stamp::min();
  if (is_held_ && next == changes_.end()) validity.until = Stamp::max();
  return {current.parent, validity};
}

LinkHistory::Samples::const_iterator LinkHistory::firstFrom(Stamp time) const {
  return std::lower_bound(samples_.begin(), samples_.end(), time,
                          [](const Sample& sample, Stamp t) { return sample.stamp < t; });
}

geometry_msgs::Transform LinkHistory::transformAt(Stamp time) const {
  const auto next = firstFrom(time);
  if (is_held_) {
    const bool is_now = next != samples_.end() && next->stamp == time;
    return (is_now || next == samples_.begin() ? next : std::prev(next))->X_PC;
  }
  // At the time of a sample that lies between two others, tf2 interpolates, too.
  const auto after = next->stamp == time ? std::next(next) : next;
  if (next == samples_.begin() || after == samples_.end()) return next->X_PC;
  const Sample& before = *std::prev(after);
  if (before.parent != after->parent) return before.X_PC;
  return interpolated(before, *after, time);
}

std::optional<Gap> LinkHistory::gapAt(Stamp time) const {
  if (is_held_) return std::nullopt;
  const auto next = firstFrom(time);
  if (next == samples_.begin() || next == samples_.end() || next->stamp == time) {
    return std::nullopt;
  }
  const Sample& before = *std::prev(next);
  return Gap{before.stamp, next->stamp, isSamePose(before, *next)};
}

std::vector<FrameId> LinkHistory::parents() const {
  std::vector<FrameId> all;
  for (const Change& change : changes_) all.push_back(change.parent);
  return all;
}

}  // namespace synthetic_dataset::motion
