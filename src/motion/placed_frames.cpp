#include "motion/placed_frames.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "motion/bag/ros_time.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {

PlacedFrames::PlacedFrames(std::shared_ptr<const FrameSource> others)
    : FrameSource(others->globalFrame()),
      others_(std::move(others)),
      names_(std::make_shared<FrameNames>(others_->names())) {}

FrameId PlacedFrames::place(const std::string& frame, const std::optional<Pose>& X_GF) {
  const FrameId id = names_->findOrAdd(frame);
  place(id, X_GF);
  return id;
}

void PlacedFrames::place(FrameId frame, const std::optional<Pose>& X_GF) {
  placed_.insert_or_assign(frame, X_GF);
}

void PlacedFrames::markAbsentInGaps(FrameId frame, const std::optional<Duration>& max_tf_gap) {
  without_holes_.insert_or_assign(frame, max_tf_gap);
}

bool PlacedFrames::isPlaced(const std::string& frame) const {
  const auto id = find(frame);
  return id && placed_.count(*id) != 0;
}

std::optional<Pose> PlacedFrames::pose(FrameId frame, Stamp time) const {
  const auto placed = placed_.find(frame);
  if (placed != placed_.end()) return placed->second;
  if (!isOfOthers(frame)) return std::nullopt;
  const auto forgotten = without_holes_.find(frame);
  const bool is_known =
      forgotten == without_holes_.end() || !others_->isInHole(frame, time, forgotten->second);
  return is_known ? others_->pose(frame, time) : std::nullopt;
}

/// Names that only this source has come after those of the others.
bool PlacedFrames::isOfOthers(FrameId frame) const {
  return static_cast<std::size_t>(frame) < others_->names().all().size();
}

std::optional<Duration> PlacedFrames::recordedPeriod(FrameId frame, Stamp time) const {
  if (placed_.count(frame) != 0 || !isOfOthers(frame)) return std::nullopt;
  return others_->recordedPeriod(frame, time);
}

void PlacedFrames::report(const std::vector<FrameId>& frames,
                          base::Diagnostics& diagnostics) const {
  std::vector<FrameId> theirs;
  std::copy_if(frames.begin(), frames.end(), std::back_inserter(theirs),
               [this](FrameId frame) { return isOfOthers(frame) && placed_.count(frame) == 0; });
  others_->report(theirs, diagnostics);
}

std::string PlacedFrames::whenKnown(FrameId frame) const {
  return isOfOthers(frame) ? others_->whenKnown(frame) : "";
}

Timeline PlacedFrames::timeline(const std::vector<std::string>& frames,
                                const TimelineOptions& options) const {
  std::vector<std::string> theirs;
  std::copy_if(frames.begin(), frames.end(), std::back_inserter(theirs),
               [this](const std::string& frame) { return !isPlaced(frame); });
  return others_->timeline(theirs, options);
}

PlacementMotion::PlacementMotion(const std::string& global_frame) : FrameSource(global_frame) {
  static_cast<void>(names_.findOrAdd(global_frame));
}

std::optional<Pose> PlacementMotion::pose(FrameId frame, Stamp /*time*/) const {
  if (frame != names_.find(globalFrame())) return std::nullopt;
  return Pose::Identity();
}

Timeline PlacementMotion::timeline(const std::vector<std::string>& frames,
                                   const TimelineOptions& options) const {
  std::vector<std::string> errors;
  for (const std::string& frame : frames) {
    if (!find(frame)) errors.push_back(lacks(frame));
  }
  if (options.scenes > Stamp::max() / options.period) {
    errors.push_back("scenes: found " + std::to_string(options.scenes) + ", one every " +
                     secondsText(options.period) +
                     "; the last one should be less than 292 years from the first");
  }
  if (!errors.empty()) throw ErrorList(errors);
  Timeline timeline;
  timeline.is_recorded = false;
  for (std::int64_t scene = 1; scene <= options.scenes; ++scene) {
    timeline.stamps.push_back(scene * options.period);
  }
  return timeline;
}

}  // namespace synthetic_dataset::motion
