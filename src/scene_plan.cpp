#include "scene_plan.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "seconds.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset {
namespace {

motion::TimelineOptions timelineOptions(const config::MotionConfig& config) {
  motion::TimelineOptions options;
  options.period = motion::periodOf(config.rate);
  options.start_offset = fromSeconds(config.start_offset);
  if (config.duration) options.duration = fromSeconds(*config.duration);
  if (config.max_tf_gap) options.max_tf_gap = fromSeconds(*config.max_tf_gap);
  return options;
}

/// Takes scenes out and counts them.
template <class Unwanted>
void leaveOut(const Unwanted& unwanted, motion::Timeline& timeline) {
  auto& stamps = timeline.stamps;
  const std::size_t before = stamps.size();
  stamps.erase(std::remove_if(stamps.begin(), stamps.end(), unwanted), stamps.end());
  timeline.left_out_unknown += static_cast<std::int64_t>(before - stamps.size());
}

/// Scenes during whose exposure a frame is not known, as at the recording's ends.
void leaveOutHalfExposed(const std::vector<std::string>& frames, Duration open,
                         const motion::FrameMotion& frame_motion, motion::Timeline& timeline) {
  const auto known = [&](const std::string& frame, Stamp time) {
    return frame_motion.hasPose(frame, time);
  };
  const auto is_half_exposed = [&](Stamp stamp) {
    return std::any_of(frames.begin(), frames.end(), [&](const std::string& frame) {
      return known(frame, stamp) &&
             !(known(frame, stamp - open / 2) && known(frame, stamp + open / 2));
    });
  };
  leaveOut(is_half_exposed, timeline);
  if (timeline.stamps.empty()) {
    throw Error(
        "effects/exposure_time, readout_time: no scene of the recording is known over its "
        "whole exposure of " +
        fixed(toSeconds(open), 4) + " s");
  }
}

}  // namespace

motion::Timeline planScenes(const motion::FrameMotion& frame_motion, const config::Config& config,
                            const std::vector<CameraRig>& cameras,
                            const std::vector<std::vector<DrivenLink>>& driven_links) {
  std::vector<std::string> frames;
  Duration open{0};
  for (const config::ObjectConfig& object : config.objects) {
    if (object.takes_part) frames.push_back(object.frame);
  }
  for (const CameraRig& camera : cameras) {
    if (camera.followsRecording()) frames.push_back(camera.frame);
    open = std::max(open, openTime(camera.shutter));
  }
  motion::Timeline timeline = frame_motion.recording()->timeline(config.global_frame, frames,
                                                                 timelineOptions(config.motion));
  if (open.count() == 0) return timeline;
  for (const auto& object : driven_links) {
    for (const DrivenLink& link : object) frames.push_back(link.frame);
  }
  leaveOutHalfExposed(frames, open, frame_motion, timeline);
  return timeline;
}

motion::Timeline planUnrelatedScenes(const config::Config& config) {
  const Duration period = motion::periodOf(config.motion.rate);
  if (config.motion.scenes > Stamp::max() / period) {
    throw Error("scenes: found " + std::to_string(config.motion.scenes) +
                " at a simulated_rate of " + Value(config.motion.rate).text() +
                " Hz; the last one should be less than 292 years from the first");
  }
  motion::Timeline timeline;
  for (std::int64_t scene = 1; scene <= config.motion.scenes; ++scene) {
    timeline.stamps.push_back(scene * period);
  }
  return timeline;
}

void thinOut(motion::Timeline& timeline, std::int64_t count) {
  std::vector<Stamp> kept;
  const auto all = static_cast<std::int64_t>(timeline.stamps.size());
  for (std::int64_t i = 0; i < count; ++i) {
    kept.push_back(timeline.stamps[static_cast<std::size_t>(i * all / count)]);
  }
  timeline.stamps = std::move(kept);
}

void leaveOutScenesWithout(const std::string& frame, const motion::FrameMotion& frame_motion,
                           motion::Timeline& timeline) {
  if (timeline.stamps.empty()) return;
  leaveOut([&](Stamp stamp) { return !frame_motion.hasPose(frame, stamp); }, timeline);
  if (timeline.stamps.empty()) {
    throw Error("a writer asks for the frame '" + frame + "', which cannot be transformed into '" +
                frame_motion.globalFrame() + "' at any scene");
  }
}

}  // namespace synthetic_dataset
