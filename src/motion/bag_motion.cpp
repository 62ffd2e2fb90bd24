#include "motion/bag_motion.h"

#include <algorithm>
#include <set>
#include <utility>

#include "base/name_list.h"
#include "motion/bag/ros_time.h"
#include "motion/tf/pose_topics.h"
#include "motion/tf/tf_topics.h"
#include "motion/tf/transform_recording.h"
#include "motion/tf/window_report.h"
#include "motion/timeline_search.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

/// The message for a timeline from which every scene was left out.
std::string noSceneLeft(const Timeline& timeline, const TimelineOptions& options) {
  const std::string longest = options.max_tf_gap ? secondsText(*options.max_tf_gap)
                                                 : "by default 10 s or 20 median periods";
  if (options.stamps && timeline.left_out_unknown + timeline.left_out_gap == 0) {
    const std::vector<Stamp>& all = *options.stamps;
    return "no picture is in the window: there are " + std::to_string(all.size()) + ", from " +
           secondsText(all.front()) + " to " + secondsText(all.back()) +
           "; start_offset and duration say which part of the recording is used";
  }
  return "no scene is left: of those in the window, " + std::to_string(timeline.left_out_unknown) +
         " are left out because a transform is not known and " +
         std::to_string(timeline.left_out_gap) +
         " because the transforms to interpolate between are further apart than max_tf_gap, " +
         longest;
}

std::string ignoredTopics(const std::vector<std::string>& topics) {
  return "the recording has TF in topics that are not read: " + base::listed(topics) +
         " (tf_topics can name them)";
}

/// The message for a recording without /tf_static; empty otherwise. Static transforms are sent only
/// once: before the recording begins, or into the first of its parts.
std::string lacksStatic(const BagReader& bags) {
  const std::string ending = "tf_static";
  for (const BagTopic& topic : bags.topics()) {
    const bool is_static =
        topic.name.size() >= ending.size() &&
        topic.name.compare(topic.name.size() - ending.size(), ending.size(), ending) == 0;
    if (is_static) return "";
  }
  return "the recording has no /tf_static: of several parts, only the first has it; "
         "bag_file should name all parts";
}

/// Adds a possible cause to the error about the first frame that is missing rather than misspelt.
void addToMissing(const std::string& cause, std::vector<std::string>& errors) {
  const auto missing = std::find_if(errors.begin(), errors.end(), [](const std::string& error) {
    return error.rfind("frame '", 0) == 0 && error.find("did you mean") == std::string::npos;
  });
  if (missing != errors.end()) *missing += "; " + cause;
}

/// The messages for bags without any usable transform.
std::vector<std::string> nothingToUse(const BagReader& bags, const TfTopics& tf,
                                      const TransformRecording& recording,
                                      const std::vector<std::string>& hints) {
  std::vector<std::string> errors;
  if (tf.readers.empty()) {
    errors = noTransforms(bags);
  } else {
    errors = recording.notes();
    errors.insert(errors.begin(), "the bags hold no transform that can be used");
  }
  errors.insert(errors.end(), hints.begin(), hints.end());
  return errors;
}

}  // namespace

BagMotion::BagMotion(const BagMotionOptions& options) : FrameSource(options.global_frame) {
  BagReader bags(options.bag_files);
  times_ = bags.times();
  notes_ = bags.notes();
  TransformRecording recording;
  const TfTopics tf = findTfTopics(bags, options.tf_topics);
  bags.read(tf.readers, [&](RecordedTransform each) { recording.add(std::move(each)); });
  PoseTopics others(bags, recording);
  const bool asks_for_robots = options.robots && others.hasJointStates();
  const auto robots = asks_for_robots ? options.robots() : std::vector<JointedRobot>{};
  others.readNamed(options.pose_topics, robots);
  others.readLacking(globalFrame(), options.frames);
  others.readJoints(robots);
  hints_ = others.hints();
  if (!tf.ignored.empty()) hints_.push_back(ignoredTopics(tf.ignored));
  lacks_static_ = lacksStatic(bags);
  if (recording.empty()) throw ErrorList(nothingToUse(bags, tf, recording, hints_));

  tree_ = recording.finish(options.stretch);
  global_ = find(globalFrame()).value_or(kNoFrame);
  if (!tf.note.empty()) notes_.push_back(tf.note);
  notes_.insert(notes_.end(), others.notes().begin(), others.notes().end());
  const std::vector<std::string> left_out = recording.notes();
  notes_.insert(notes_.end(), left_out.begin(), left_out.end());
  stretches_ = recording.stretches();
  stretch_ = recording.stretch();
  clock_offset_ = recording.clockOffset();
  findings_ = recording.findings();
}

bool BagMotion::hasOwnClock() const {
  constexpr Duration kSame = std::chrono::seconds(1);
  return stretches_.size() > 1 || clock_offset_ >= kSame || clock_offset_ <= -kSame;
}

std::optional<Pose> BagMotion::pose(FrameId frame, Stamp time) const {
  if (global_ == kNoFrame || frame == kNoFrame || !isRosTime(time)) return std::nullopt;
  return tree_.transform(global_, frame, time);
}

std::optional<Duration> BagMotion::recordedPeriod(FrameId frame, Stamp time) const {
  if (global_ == kNoFrame || frame == kNoFrame) return std::nullopt;
  std::optional<Duration> shortest;
  for (const FrameId link : tree_.connection(global_, frame, time).links) {
    const Duration period = tree_.link(link).medianPeriod();
    if (period.count() > 0 && (!shortest || period < *shortest)) shortest = period;
  }
  return shortest;
}

Timeline BagMotion::timeline(const std::vector<std::string>& frames,
                             const TimelineOptions& options) const {
  std::vector<std::string> named = frames;
  named.insert(named.end(), options.sometimes.begin(), options.sometimes.end());
  std::vector<std::string> errors = unknownFrames(tree_, globalFrame(), named);
  if (!errors.empty()) {
    if (!lacks_static_.empty()) addToMissing(lacks_static_, errors);
    errors.insert(errors.end(), hints_.begin(), hints_.end());
    for (std::string& error : optionErrors(times_, options)) errors.push_back(std::move(error));
    throw ErrorList(errors);
  }
  FramesToKnow wanted{global_, {}};
  for (const std::string& frame : frames) wanted.frames.push_back(*find(frame));
  RecordedTimes recorded = times_;
  RecordedTimes all = times_;
  if (hasOwnClock()) {
    all = {stretches_[stretch_].first, stretches_[stretch_].last};
    const auto known = knownTimes(tree_, wanted, all);
    if (!known) throw ErrorList(whyNoWindow(tree_, wanted, all, all, options));
    recorded = *known;
  }
  errors = optionErrors(recorded, options);
  if (!errors.empty()) throw ErrorList(errors);

  const RecordedTimes part = usedPart(recorded, options);
  std::optional<Timeline> timeline = findTimeline(tree_, wanted, part, options);
  if (!timeline) {
    errors = whyNoWindow(tree_, wanted, recorded, part, options);
    errors.insert(errors.end(), hints_.begin(), hints_.end());
    throw ErrorList(errors);
  }
  if (timeline->stamps.empty()) throw ErrorList({noSceneLeft(*timeline, options)});
  if (hasOwnClock()) noteClock(part.start, timeline->diagnostics);
  const Duration rest = recorded.end - part.start;
  if (options.duration && *options.duration > rest) {
    timeline->diagnostics.note("duration", "found " + secondsText(*options.duration) +
                                               "; the recording has " + secondsText(rest) +
                                               " from there on, and all of it is used");
  }
  for (const std::string& frame : options.sometimes) wanted.frames.push_back(*find(frame));
  const RecordedTimes usable = hasOwnClock() && !options.duration ? all : part;
  timeline->used = usable.end - usable.start;
  timeline->costs = frameCosts(tree_, wanted, usable);
  return *std::move(timeline);
}

void BagMotion::noteClock(Stamp start, base::Diagnostics& diagnostics) const {
  if (stretches_.size() > 1) return;  // reported separately
  const bool is_behind = clock_offset_ > Duration{0};
  diagnostics.warning("",
                      "the recording's time stamps are " +
                          secondsText(is_behind ? clock_offset_ : -clock_offset_) +
                          (is_behind ? " behind" : " ahead of") +
                          " its record times (median): scenes begin at the first stamp at which TF "
                          "is known, " +
                          secondsText(start));
}

/// The given frames, the global frame, and all their ancestors.
std::vector<FrameId> BagMotion::withAncestors(std::vector<FrameId> frames) const {
  if (global_ != kNoFrame) frames.push_back(global_);
  std::set<FrameId> seen(frames.begin(), frames.end());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    for (const FrameId parent : tree_.link(frames[i]).parents()) {
      if (seen.insert(parent).second) frames.push_back(parent);
    }
  }
  return frames;
}

void BagMotion::report(const std::vector<FrameId>& frames, base::Diagnostics& diagnostics) const {
  diagnostics.add(base::Severity::kWarning, notes_);
  if (stretches_.size() > 1) {
    diagnostics.warning("",
                        "time goes back in the recording, as when a simulation is reset; it is cut "
                        "there into the stretches " +
                            stretchList(stretches_) + "; scenes come from stretch " +
                            std::to_string(stretch_) + " (stretch: selects another)");
  }
  const std::vector<FrameId> used = withAncestors(frames);
  for (const FrameFinding& finding : findings_) {
    if (std::find(used.begin(), used.end(), finding.child) == used.end()) continue;
    diagnostics.warning("", finding.message);
  }
}

bool BagMotion::isInHole(FrameId frame, Stamp time,
                         const std::optional<Duration>& max_tf_gap) const {
  if (global_ == kNoFrame || frame == kNoFrame) return false;
  const std::vector<FrameId> links = tree_.connection(global_, frame, time).links;
  return std::any_of(links.begin(), links.end(), [&](FrameId child) {
    return isForbidden(tree_.link(child), time, max_tf_gap);
  });
}

std::string BagMotion::whenKnown(FrameId frame) const {
  if (global_ == kNoFrame || frame == kNoFrame) return "";
  const std::vector<Validity> times = tree_.knownTimes(global_, frame);
  if (times.empty()) return "; it is never known";
  return "; it is known " + stretchesText(times, times_.start);
}

}  // namespace synthetic_dataset::motion
