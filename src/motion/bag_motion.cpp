#include "motion/bag_motion.h"

#include <utility>

#include <tf2/buffer_core.h>
#include <tf2/exceptions.h>

#include "motion/bag_reader.h"
#include "motion/frame_names.h"
#include "motion/frame_tree.h"
#include "motion/ros_time.h"
#include "motion/time_text.h"
#include "motion/timeline_search.h"
#include "motion/transform_recording.h"
#include "motion/window_report.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {

struct BagMotion::Impl {
  RecordedTimes times;
  TransformRecording recording;
  std::unique_ptr<tf2::BufferCore> buffer;
  std::vector<std::string> notes;

  [[nodiscard]] const FrameTree& tree() const { return recording.tree(); }
};

namespace {

Pose toPose(const geometry_msgs::Transform& transform) {
  const auto& t = transform.translation;
  const auto& q = transform.rotation;
  return makePose({t.x, t.y, t.z}, Eigen::Quaterniond(q.w, q.x, q.y, q.z));
}

std::vector<std::string> withoutLeadingSlashes(const std::vector<std::string>& frames) {
  std::vector<std::string> names;
  for (const std::string& frame : frames) names.push_back(motion::withoutLeadingSlashes(frame));
  return names;
}

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

BagMotion::BagMotion(const std::vector<std::string>& bag_files) : impl_(new Impl) {
  TransformRecording& recording = impl_->recording;
  impl_->times = readTransforms(
      bag_files, [&](const geometry_msgs::TransformStamped& transform, TransformKind kind,
                     const std::string& file) { recording.add(transform, kind, file); });
  if (recording.empty()) {
    std::vector<std::string> errors = recording.notes();
    errors.insert(errors.begin(), "the bags hold no transform that can be used");
    throw ErrorList(errors);
  }
  recording.finish();
  impl_->notes = recording.notes();
  impl_->buffer = recording.moveToBuffer();
}

BagMotion::~BagMotion() = default;
BagMotion::BagMotion(BagMotion&&) noexcept = default;
BagMotion& BagMotion::operator=(BagMotion&&) noexcept = default;

Stamp BagMotion::start() const { return impl_->times.start; }
Stamp BagMotion::end() const { return impl_->times.end; }
const std::vector<std::string>& BagMotion::notes() const { return impl_->notes; }

bool BagMotion::knowsFrame(const std::string& frame) const {
  return impl_->tree().find(motion::withoutLeadingSlashes(frame)).has_value();
}

std::string BagMotion::suggestFrame(const std::string& frame) const {
  return didYouMeanFrame(frame, impl_->tree().names());
}

Pose BagMotion::transform(const std::string& target, const std::string& source, Stamp time) const {
  const std::string target_name = motion::withoutLeadingSlashes(target);
  const std::string source_name = motion::withoutLeadingSlashes(source);
  const auto failure = [&](const std::string& reason) {
    return Error("the transform of '" + source_name + "' into '" + target_name + "' at " +
                 secondsText(time) + ": " + reason);
  };
  if (!isRosTime(time)) throw failure("the time is outside of what ROS can express");
  try {
    return toPose(
        impl_->buffer->lookupTransform(target_name, source_name, toRosTime(time)).transform);
  } catch (const tf2::TransformException& error) {
    throw failure(error.what());
  }
}

bool BagMotion::canTransform(const std::string& target, const std::string& source,
                             Stamp time) const {
  // Not tf2's canTransform: that one logs an empty name.
  const auto target_frame = impl_->tree().find(motion::withoutLeadingSlashes(target));
  const auto source_frame = impl_->tree().find(motion::withoutLeadingSlashes(source));
  return target_frame && source_frame && isRosTime(time) &&
         impl_->tree().connection(*target_frame, *source_frame, time).known;
}

Timeline BagMotion::timeline(const std::string& global_frame,
                             const std::vector<std::string>& frames,
                             const TimelineOptions& options) const {
  const FrameTree& tree = impl_->tree();
  const std::string global_name = motion::withoutLeadingSlashes(global_frame);
  const std::vector<std::string> names = withoutLeadingSlashes(frames);
  std::vector<std::string> errors = optionErrors(impl_->times, options);
  for (std::string& error : unknownFrames(tree, global_name, names)) {
    errors.push_back(std::move(error));
  }
  if (!errors.empty()) throw ErrorList(errors);

  const RecordedTimes part = usedPart(impl_->times, options);
  FramesToKnow wanted{*tree.find(global_name), {}};
  for (const std::string& name : names) wanted.frames.push_back(*tree.find(name));
  std::optional<Timeline> timeline = findTimeline(tree, wanted, part, options);
  if (!timeline) throw ErrorList(whyNoWindow(tree, wanted, impl_->times, part, options));
  if (timeline->stamps.empty()) throw ErrorList({noSceneLeft(*timeline, options)});
  return *std::move(timeline);
}

}  // namespace synthetic_dataset::motion
