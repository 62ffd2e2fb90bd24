#include "motion/bag_motion.h"

#include <utility>

#include "motion/ros_time.h"
#include "motion/time_text.h"
#include "motion/timeline_search.h"
#include "motion/transform_recording.h"
#include "motion/window_report.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

/// Every scene of the window was left out.
std::string noSceneLeft(const Timeline& timeline, const TimelineOptions& options) {
  std::string message = "no scene is left: of those in the window, " +
                        std::to_string(timeline.left_out_unknown) +
                        " are left out because a transform is not known";
  if (options.max_tf_gap) {
    message +=
        " and " + std::to_string(timeline.left_out_gap) +
        " because the transforms to interpolate between are further apart than max_tf_gap, " +
        secondsText(*options.max_tf_gap);
  }
  return message;
}

}  // namespace

BagMotion::BagMotion(const std::vector<std::string>& bag_files, const std::string& global_frame)
    : FrameSource(global_frame) {
  TransformRecording recording;
  times_ = readTransforms(bag_files,
                          [&](const geometry_msgs::TransformStamped& transform, TransformKind kind,
                              const std::string& file) { recording.add(transform, kind, file); });
  if (recording.empty()) {
    std::vector<std::string> errors = recording.notes();
    errors.insert(errors.begin(), "the bags hold no transform that can be used");
    throw ErrorList(errors);
  }
  tree_ = recording.finish();
  global_ = find(global_frame).value_or(kNoFrame);
  notes_ = recording.notes();
}

std::optional<Pose> BagMotion::pose(FrameId frame, Stamp time) const {
  if (global_ == kNoFrame || frame == kNoFrame || !isRosTime(time)) return std::nullopt;
  return tree_.transform(global_, frame, time);
}

Timeline BagMotion::timeline(const std::vector<std::string>& frames,
                             const TimelineOptions& options) const {
  std::vector<std::string> errors = optionErrors(times_, options);
  for (std::string& error : unknownFrames(tree_, globalFrame(), frames)) {
    errors.push_back(std::move(error));
  }
  if (!errors.empty()) throw ErrorList(errors);

  const RecordedTimes part = usedPart(times_, options);
  FramesToKnow wanted{global_, {}};
  for (const std::string& frame : frames) wanted.frames.push_back(*find(frame));
  std::optional<Timeline> timeline = findTimeline(tree_, wanted, part, options);
  if (!timeline) throw ErrorList(whyNoWindow(tree_, wanted, times_, part, options));
  if (timeline->stamps.empty()) throw ErrorList({noSceneLeft(*timeline, options)});
  return *std::move(timeline);
}

}  // namespace synthetic_dataset::motion
