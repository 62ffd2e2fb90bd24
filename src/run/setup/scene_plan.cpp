#include "run/setup/scene_plan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/seconds.h"
#include "randomize/appearance/entry_draws.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::run {
namespace {

motion::TimelineOptions timelineOptions(const config::Config& config) {
  const motion::MotionOptions& motion = config.motion;
  motion::TimelineOptions options;
  options.period = motion::periodOf(motion.rate);
  options.scenes = motion.scenes;
  options.start_offset = base::fromSeconds(motion.start_offset);
  if (motion.duration) options.duration = base::fromSeconds(*motion.duration);
  if (motion.max_tf_gap) {
    options.max_tf_gap =
        std::isinf(*motion.max_tf_gap) ? Duration::max() : base::fromSeconds(*motion.max_tf_gap);
  }
  const auto& jitter = config.randomization.time_jitter;
  if (!jitter) return options;
  // By the regular time, not by the scene's number: what another frame leaves out moves no scene.
  options.jitter = [&jitter, seed = static_cast<std::uint64_t>(config.seed)](std::int64_t index) {
    randomize::EntryDraws draws(seed, index);
    return base::fromSeconds(*draws.number("time/jitter", jitter));
  };
  return options;
}

/// Takes scenes out and counts them.
template <class Unwanted>
void leaveOut(const Unwanted& unwanted, motion::Timeline& timeline) {
  const motion::Timeline all = timeline;
  timeline.stamps.clear();
  timeline.jitter.clear();
  for (std::size_t i = 0; i < all.stamps.size(); ++i) {
    if (unwanted(all.stamps[i])) continue;
    timeline.stamps.push_back(all.stamps[i]);
    if (!all.jitter.empty()) timeline.jitter.push_back(all.jitter[i]);
  }
  timeline.left_out_unknown +=
      static_cast<std::int64_t>(all.stamps.size() - timeline.stamps.size());
}

/// Scenes during whose exposure a frame is not known, as at the recording's ends.
void leaveOutHalfExposed(const std::vector<motion::FrameId>& ids, Duration open,
                         const motion::FrameSource& frames, motion::Timeline& timeline) {
  const auto is_half_exposed = [&](Stamp stamp) {
    return std::any_of(ids.begin(), ids.end(), [&](motion::FrameId id) {
      return frames.pose(id, stamp) &&
             !(frames.pose(id, stamp - open / 2) && frames.pose(id, stamp + open / 2));
    });
  };
  leaveOut(is_half_exposed, timeline);
  if (timeline.stamps.empty()) {
    throw Error(
        "effects/exposure_time, readout_time, lidars: no scene of the recording is known over "
        "its whole exposure, or sweep, of " +
        fixed(toSeconds(open), 4) + " s");
  }
}

/// "`frame: base_link` in the group rover names it", for an object whose frame the recording has in
/// another writing, mostly without a prefix.
std::string cureOf(const scene::ObjectOptions& object, const motion::FrameSource& frames) {
  std::string cures;
  for (const std::string& like : motion::framesLike(object.frame, frames.names().all())) {
    cures += (cures.empty() ? "`frame: " : " or `frame: ") + like + "`";
  }
  if (cures.empty()) return "";
  return object.name + "/frame: found no frame '" + object.frame + "' in " + frames.title() +
         "; in the group " + object.name + ", " + cures + " names one as a whole";
}

/// An error about an object's frame, with the setting that names the frame.
std::string withSetting(const std::string& message,
                        const std::vector<scene::ObjectOptions>& objects) {
  for (const scene::ObjectOptions& object : objects) {
    if (message.rfind("frame '" + object.frame + "' ", 0) != 0) continue;
    return object.name + (object.frame_is_given ? "/frame: " : "/frame_id: ") + message;
  }
  return message;
}

/// @throws ErrorList as FrameSource::timeline, and what would mend it
motion::Timeline findTimeline(const std::vector<std::string>& names,
                              const motion::FrameSource& frames, const config::Config& config,
                              std::optional<std::vector<Stamp>> stamps) {
  motion::TimelineOptions options = timelineOptions(config);
  options.stamps = std::move(stamps);
  try {
    return frames.timeline(names, options);
  } catch (const ErrorList& errors) {
    std::vector<std::string> messages;
    for (const std::string& each : errors.messages()) {
      messages.push_back(withSetting(each, config.objects));
    }
    for (const scene::ObjectOptions& object : config.objects) {
      if (object.is_distractor || !object.takes_part || frames.find(object.frame)) continue;
      const std::string cure = cureOf(object, frames);
      if (!cure.empty()) messages.push_back(cure);
    }
    throw ErrorList(std::move(messages));
  }
}

}  // namespace

motion::Timeline planScenes(const motion::FrameSource& frames, const config::Config& config,
                            const std::vector<scene::CameraRig>& cameras,
                            const std::vector<lidar::LidarRig>& lidars,
                            const std::vector<std::vector<scene::DrivenLinks>>& driven_links,
                            std::optional<std::vector<Stamp>> stamps) {
  std::vector<std::string> names;
  Duration open{0};
  for (const scene::ObjectOptions& object : config.objects) names.push_back(object.frame);
  for (const scene::CameraRig& camera : cameras) {
    if (const std::string frame = camera.neededFrame(); !frame.empty()) names.push_back(frame);
    open = std::max(open, scene::openTime(camera.shutter));
  }
  for (const lidar::LidarRig& lidar : lidars) {
    if (lidar.followsFrame()) names.push_back(lidar.frame);
    open = std::max(open, lidar::sweepTime(lidar.model));
  }
  motion::Timeline timeline = findTimeline(names, frames, config, std::move(stamps));
  if (open.count() == 0) return timeline;
  std::vector<motion::FrameId> ids;
  for (const std::string& name : names) ids.push_back(*frames.find(name));
  for (const std::vector<scene::DrivenLinks>& object : driven_links) {
    for (const scene::DrivenLinks& variant : object) {
      for (const scene::DrivenLink& link : variant) ids.push_back(link.frame);
    }
  }
  leaveOutHalfExposed(ids, open, frames, timeline);
  return timeline;
}

Duration shortestPeriod(const config::Config& config) {
  const Duration period = motion::periodOf(config.motion.rate);
  const auto& jitter = config.randomization.time_jitter;
  if (!jitter) return period;
  const Duration range = base::fromSeconds(jitter->highest()) - base::fromSeconds(jitter->lowest());
  return std::max(period - range, Duration{0});
}

void thinOut(motion::Timeline& timeline, std::int64_t count) {
  const motion::Timeline all = timeline;
  const auto all_count = static_cast<std::int64_t>(all.stamps.size());
  timeline.stamps.clear();
  timeline.jitter.clear();
  for (std::int64_t i = 0; i < count; ++i) {
    const auto index = static_cast<std::size_t>(all.is_recorded ? i * all_count / count : i);
    timeline.stamps.push_back(all.stamps[index]);
    if (!all.jitter.empty()) timeline.jitter.push_back(all.jitter[index]);
  }
}

void leaveOutScenesWithout(const std::string& frame, const motion::FrameSource& frames,
                           motion::Timeline& timeline) {
  if (timeline.stamps.empty()) return;
  const motion::FrameId id = *frames.find(frame);
  leaveOut([&](Stamp stamp) { return !frames.pose(id, stamp); }, timeline);
  if (timeline.stamps.empty()) {
    throw Error("a writer asks for the frame '" + frame + "', which cannot be transformed into '" +
                frames.globalFrame() + "' at any scene");
  }
}

}  // namespace synthetic_dataset::run
