#include "run/setup/scene_plan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>

#include "base/name_list.h"
#include "base/seconds.h"
#include "randomize/appearance/entry_draws.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::run {
namespace {

/// The longest gap that is interpolated; nothing: determined for each frame.
std::optional<Duration> longestGap(const motion::MotionOptions& motion) {
  if (!motion.max_tf_gap) return std::nullopt;
  return std::isinf(*motion.max_tf_gap) ? Duration::max() : base::fromSeconds(*motion.max_tf_gap);
}

motion::TimelineOptions timelineOptions(const config::Config& config) {
  const motion::MotionOptions& motion = config.motion;
  motion::TimelineOptions options;
  options.period = motion::periodOf(motion.rate);
  options.scenes = motion.scenes;
  options.start_offset = base::fromSeconds(motion.start_offset);
  if (motion.duration) options.duration = base::fromSeconds(*motion.duration);
  options.max_tf_gap = longestGap(motion);
  const auto& jitter = config.randomization.time_jitter;
  if (!jitter) return options;
  // Depends on the regular time, not on the scene's number, so that omitted scenes do not shift
  // others.
  options.jitter = [&jitter, seed = static_cast<std::uint64_t>(config.seed)](std::int64_t index) {
    randomize::EntryDraws draws(seed, index);
    return base::fromSeconds(*draws.number("time/jitter", jitter));
  };
  return options;
}

/// Removes unwanted scenes and counts them.
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

/// The period around a scene's stamp in which something is exposed or measured.
using TimesAround = std::function<motion::TimeRange(Stamp scene)>;

/// Removes scenes during whose exposure a frame is unknown, for example at the recording's ends, or
/// in which an object that may be absent appears or disappears.
/// @param sometimes  the frames of objects that may be absent
void leaveOutHalfExposed(const std::vector<motion::FrameId>& ids,
                         const std::vector<motion::FrameId>& sometimes, const TimesAround& open,
                         const motion::FrameSource& frames, motion::Timeline& timeline) {
  const auto isKnown = [&](motion::FrameId id, Stamp time) {
    return frames.pose(id, time).has_value();
  };
  const auto is_half_exposed = [&](Stamp stamp) {
    const auto [first, last] = open(stamp);
    const Stamp begin = stamp + first;
    const Stamp end = stamp + last;
    const auto isLost = [&](motion::FrameId id) {
      return isKnown(id, stamp) && !(isKnown(id, begin) && isKnown(id, end));
    };
    const auto changes = [&](motion::FrameId id) {
      return isLost(id) || (!isKnown(id, stamp) && (isKnown(id, begin) || isKnown(id, end)));
    };
    return std::any_of(ids.begin(), ids.end(), isLost) ||
           std::any_of(sometimes.begin(), sometimes.end(), changes);
  };
  if (timeline.stamps.empty()) return;
  const auto [first, last] = open(timeline.stamps.front());
  leaveOut(is_half_exposed, timeline);
  if (timeline.stamps.empty()) {
    throw Error(
        "effects/exposure_time, readout_time, lidars: no scene of the recording has known poses "
        "over its whole exposure, or sweep, of " +
        fixed(toSeconds(last - first), 4) + " s");
  }
}

/// "`frame: base_link` in the group rover names it", for an object whose frame has a slightly
/// different name in the recording, usually one without a prefix.
std::string cureOf(const scene::ObjectOptions& object, const motion::FrameSource& frames) {
  std::string cures;
  for (const std::string& like : motion::framesLike(object.frame, frames.names().all())) {
    cures += (cures.empty() ? "`frame: " : " or `frame: ") + like + "`";
  }
  if (cures.empty()) return "";
  return object.name + "/frame: found no frame '" + object.frame + "' in " + frames.title() +
         "; in the group " + object.name + ", " + cures + " names one in full";
}

/// Adds to an error about an object's frame the setting that names the frame.
std::string withSetting(const std::string& message,
                        const std::vector<scene::ObjectOptions>& objects) {
  for (const scene::ObjectOptions& object : objects) {
    if (message.rfind("frame '" + object.frame + "' ", 0) != 0) continue;
    return object.name + (object.frame_is_given ? "/frame: " : "/frame_id: ") + message;
  }
  return message;
}

/// @throws ErrorList as FrameSource::timeline, with remedies
motion::Timeline findTimeline(const std::vector<std::string>& names,
                              const motion::FrameSource& frames, const config::Config& config,
                              const motion::TimelineOptions& options) {
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

/// Whether scenes are made without this object while its pose is unknown.
bool maybeAbsent(const scene::ObjectOptions& object) {
  return object.when_unknown == scene::WhenUnknown::kAbsent && object.takes_part &&
         !object.is_distractor;
}

/// Whether a camera is placed so that it sees some object, while all objects may be absent.
bool needsAnObject(const config::Config& config) {
  const auto looksAtAny = [](const scene::CameraOptions& camera) {
    return camera.sample && !camera.sample->look_at_point_G;
  };
  const auto isAlwaysThere = [](const scene::ObjectOptions& object) {
    return object.takes_part && !object.is_distractor && !maybeAbsent(object);
  };
  return std::any_of(config.cameras.begin(), config.cameras.end(), looksAtAny) &&
         std::none_of(config.objects.begin(), config.objects.end(), isAlwaysThere);
}

std::string secondsOf(Duration time) { return fixed(toSeconds(time), 1) + " s"; }

/// Notes for each object that may be absent in how many scenes it is present, and why.
void noteAbsences(const motion::FrameSource& frames, const config::Config& config,
                  motion::Timeline& timeline) {
  for (const scene::ObjectOptions& object : config.objects) {
    if (!maybeAbsent(object)) continue;
    const auto frame = *frames.find(object.frame);
    const auto& stamps = timeline.stamps;
    const auto absent = std::count_if(stamps.begin(), stamps.end(),
                                      [&](Stamp stamp) { return !frames.pose(frame, stamp); });
    if (absent == 0) continue;
    const auto cost = std::find_if(
        timeline.costs.begin(), timeline.costs.end(),
        [&](const motion::FrameCost& each) { return frames.find(each.frame) == frame; });
    std::string text = "its frame '" + object.frame + "' is not known at " +
                       std::to_string(absent) + " of " + std::to_string(stamps.size()) +
                       " scenes, which are made without it";
    if (cost != timeline.costs.end()) text += ": " + cost->why;
    if (static_cast<std::size_t>(absent) == stamps.size()) {
      timeline.diagnostics.warning(object.name, std::move(text));
    } else {
      timeline.diagnostics.note(object.name, std::move(text));
    }
  }
}

/// The time lost to a link of the TF tree, and who is affected.
struct LostTime {
  Duration unknown{0};
  std::vector<std::string> whom;
  std::string cures;
};

/// Warns of the objects' and cameras' frames, and the TF links, that cost more than a tenth of the
/// recording.
void warnOfLostTime(const config::Config& config, const std::vector<scene::CameraRig>& cameras,
                    motion::Timeline& timeline) {
  constexpr double kMuch = 0.1;
  std::map<std::string, LostTime> by_link;
  const auto add = [&](const std::string& frame, const std::string& name, bool is_object) {
    for (const motion::FrameCost& cost : timeline.costs) {
      const bool is_much = toSeconds(cost.unknown) > kMuch * toSeconds(timeline.used);
      if (!is_much || cost.frame != motion::withoutLeadingSlashes(frame)) continue;
      LostTime& lost = by_link[cost.why];
      lost.unknown = std::max(lost.unknown, cost.unknown);
      lost.whom.push_back(name);
      if (is_object && lost.cures.empty()) lost.cures = name;
    }
  };
  for (const scene::ObjectOptions& object : config.objects) {
    if (!maybeAbsent(object)) add(object.frame, object.name, true);
  }
  for (const scene::CameraRig& camera : cameras) {
    if (camera.followsFrame()) add(camera.frame, camera.name, false);
  }
  for (const auto& [why, lost] : by_link) {
    timeline.diagnostics.warning(
        base::listed(lost.whom),
        "no scenes in " + secondsOf(lost.unknown) + " of the recording's " +
            secondsOf(timeline.used) + ", in which " +
            (lost.whom.size() == 1 ? "its pose is" : "their poses are") + " unknown: " + why +
            (lost.cures.empty() ? ""
                                : "; `when_unknown: absent` in the group " + lost.cures +
                                      " makes these scenes without it"));
  }
}

}  // namespace

motion::Timeline planScenes(const motion::FrameSource& frames, const config::Config& config,
                            const std::vector<scene::CameraRig>& cameras,
                            const std::vector<lidar::LidarRig>& lidars,
                            const std::vector<std::vector<scene::DrivenLinks>>& driven_links,
                            std::optional<std::vector<Stamp>> stamps) {
  motion::TimelineOptions options = timelineOptions(config);
  options.stamps = std::move(stamps);
  std::vector<std::string> names;
  Duration exposed{0};
  for (const scene::ObjectOptions& object : config.objects) {
    (maybeAbsent(object) ? options.sometimes : names).push_back(object.frame);
  }
  for (const scene::CameraRig& camera : cameras) {
    if (const std::string frame = camera.neededFrame(); !frame.empty()) names.push_back(frame);
    exposed = std::max(exposed, scene::openTime(camera.shutter));
  }
  for (const lidar::LidarRig& lidar : lidars) {
    if (lidar.followsFrame()) names.push_back(lidar.frame);
  }
  motion::Timeline timeline = findTimeline(names, frames, config, options);
  const auto idsOf = [&](const std::vector<std::string>& all) {
    std::vector<motion::FrameId> ids;
    for (const std::string& name : all) ids.push_back(*frames.find(name));
    return ids;
  };
  const std::vector<motion::FrameId> sometimes = idsOf(options.sometimes);
  if (needsAnObject(config)) {
    leaveOut(
        [&](Stamp stamp) {
          return std::none_of(sometimes.begin(), sometimes.end(), [&](motion::FrameId frame) {
            return frames.pose(frame, stamp).has_value();
          });
        },
        timeline);
  }
  noteAbsences(frames, config, timeline);
  warnOfLostTime(config, cameras, timeline);
  if (exposed.count() == 0 && lidars.empty()) return timeline;
  std::vector<motion::FrameId> ids = idsOf(names);
  for (const std::vector<scene::DrivenLinks>& object : driven_links) {
    for (const scene::DrivenLinks& variant : object) {
      for (const scene::DrivenLink& link : variant) ids.push_back(link.frame);
    }
  }
  const TimesAround open = [&](Stamp scene) {
    motion::TimeRange times{-exposed / 2, exposed / 2};
    for (const lidar::LidarRig& lidar : lidars) {
      const motion::TimeRange sweep = lidar.sweepAt(scene);
      times = {std::min(times.first, sweep.first), std::max(times.last, sweep.last)};
    }
    return times;
  };
  leaveOutHalfExposed(ids, sometimes, open, frames, timeline);
  return timeline;
}

void markAbsentInGaps(const config::Config& config, motion::PlacedFrames& frames) {
  for (const scene::ObjectOptions& object : config.objects) {
    const auto frame = frames.find(object.frame);
    if (frame && maybeAbsent(object)) frames.markAbsentInGaps(*frame, longestGap(config.motion));
  }
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
