#include "motion/placement_motion.h"

#include "motion/bag/ros_time.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {

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
