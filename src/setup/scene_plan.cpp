#include "setup/scene_plan.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "appearance/entry_draws.h"
#include "base/seconds.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset {
namespace {

motion::TimelineOptions timelineOptions(const config::Config& config) {
  const motion::MotionOptions& motion = config.motion;
  motion::TimelineOptions options;
  options.period = motion::periodOf(motion.rate);
  options.start_offset = base::fromSeconds(motion.start_offset);
  if (motion.duration) options.duration = base::fromSeconds(*motion.duration);
  if (motion.max_tf_gap) options.max_tf_gap = base::fromSeconds(*motion.max_tf_gap);
  const auto& jitter = config.randomization.time_jitter;
  if (!jitter) return options;
  // By the regular time, not by the scene's number: what another frame leaves out moves no scene.
  options.jitter = [&jitter, seed = static_cast<std::uint64_t>(config.seed)](std::int64_t place) {
    appearance::EntryDraws draws(seed, place);
    return base::fromSeconds(*draws.number("time/jitter", jitter));
  };
  return options;
}

/// Takes scenes out and counts them.
template <class Unwanted>
void leaveOut(const Unwanted& unwanted, motion::Timeline& timeline) {
  motion::Timeline kept;
  for (std::size_t i = 0; i < timeline.stamps.size(); ++i) {
    if (unwanted(timeline.stamps[i])) continue;
    kept.stamps.push_back(timeline.stamps[i]);
    if (!timeline.jitter.empty()) kept.jitter.push_back(timeline.jitter[i]);
  }
  timeline.left_out_unknown +=
      static_cast<std::int64_t>(timeline.stamps.size() - kept.stamps.size());
  timeline.stamps = std::move(kept.stamps);
  timeline.jitter = std::move(kept.jitter);
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
                            const std::vector<std::vector<DrivenLinks>>& driven_links) {
  std::vector<std::string> frames;
  Duration open{0};
  for (const ObjectOptions& object : config.objects) {
    if (object.takes_part) frames.push_back(object.frame);
  }
  for (const CameraRig& camera : cameras) {
    if (camera.followsRecording()) frames.push_back(camera.frame);
    open = std::max(open, openTime(camera.shutter));
  }
  motion::Timeline timeline =
      frame_motion.recording()->timeline(config.global_frame, frames, timelineOptions(config));
  if (open.count() == 0) return timeline;
  for (const std::vector<DrivenLinks>& object : driven_links) {
    for (const DrivenLinks& variant : object) {
      for (const DrivenLink& link : variant) frames.push_back(link.frame);
    }
  }
  leaveOutHalfExposed(frames, open, frame_motion, timeline);
  return timeline;
}

Duration shortestPeriod(const config::Config& config) {
  const Duration period = motion::periodOf(config.motion.rate);
  const auto& jitter = config.randomization.time_jitter;
  if (!jitter) return period;
  const Duration range = base::fromSeconds(jitter->highest()) - base::fromSeconds(jitter->lowest());
  return std::max(period - range, Duration{0});
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
  const motion::Timeline all = timeline;
  const auto all_count = static_cast<std::int64_t>(all.stamps.size());
  timeline.stamps.clear();
  timeline.jitter.clear();
  for (std::int64_t i = 0; i < count; ++i) {
    const auto place = static_cast<std::size_t>(i * all_count / count);
    timeline.stamps.push_back(all.stamps[place]);
    if (!all.jitter.empty()) timeline.jitter.push_back(all.jitter[place]);
  }
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
