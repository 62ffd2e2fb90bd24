#include "motion/link_history.h"

#include <algorithm>
#include <iterator>

namespace synthetic_dataset::motion {

void Validity::intersect(const Validity& other) {
  from = std::max(from, other.from);
  until = std::min(until, other.until);
}

LinkHistory LinkHistory::fixedTo(FrameIndex parent) {
  LinkHistory link;
  link.fixed_parent_ = parent;
  return link;
}

LinkHistory LinkHistory::sampledAt(const std::vector<Sample>& samples) {
  LinkHistory link;
  link.stamps_.reserve(samples.size());
  for (const Sample& sample : samples) {
    link.stamps_.push_back(sample.stamp);
    const bool changed = link.changes_.empty() || link.changes_.back().parent != sample.parent;
    if (changed) link.changes_.push_back(sample);
  }
  return link;
}

LinkHistory::Parent LinkHistory::parentAt(Stamp time) const {
  if (stamps_.empty()) return {fixed_parent_, {}};
  constexpr Duration kTick{1};
  if (time < stamps_.front()) return {kNoFrame, {Stamp::min(), stamps_.front() - kTick}};
  if (time > stamps_.back()) return {kNoFrame, {stamps_.back() + kTick, Stamp::max()}};
  const auto next =
      std::upper_bound(changes_.begin(), changes_.end(), time,
                       [](Stamp t, const Sample& change) { return t < change.stamp; });
  const Sample& current = *std::prev(next);
  const Stamp until = next == changes_.end() ? stamps_.back() : next->stamp - kTick;
  return {current.parent, {current.stamp, until}};
}

Duration LinkHistory::gapAt(Stamp time) const {
  const auto next = std::lower_bound(stamps_.begin(), stamps_.end(), time);
  if (next == stamps_.begin() || next == stamps_.end() || *next == time) return Duration{0};
  return *next - *std::prev(next);
}

std::vector<FrameIndex> LinkHistory::parents() const {
  std::vector<FrameIndex> all;
  if (fixed_parent_ != kNoFrame) all.push_back(fixed_parent_);
  for (const Sample& change : changes_) all.push_back(change.parent);
  return all;
}

}  // namespace synthetic_dataset::motion
