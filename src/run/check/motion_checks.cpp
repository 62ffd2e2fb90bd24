#include "run/check/motion_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/name_list.h"
#include "run/check/moments.h"
#include "scene/camera_rig.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::run {
namespace {

/// Smaller differences do not count as motion; localization jitters by more.
constexpr double kStill = 1e-4;  // [m] and [rad]

bool isSamePlace(const Pose& one, const Pose& other) {
  return (one.translation() - other.translation()).norm() < kStill &&
         Eigen::AngleAxisd(one.linear().transpose() * other.linear()).angle() < kStill;
}

/// A frame of the recording that an object or camera follows.
struct FollowedFrame {
  std::string owner;  ///< the object or camera
  std::string name;
  motion::FrameId id = motion::kNoFrame;
  bool is_objects = false;
};

std::vector<FollowedFrame> followedFrames(const MotionSetup& motion) {
  std::vector<FollowedFrame> frames;
  for (const scene::ObjectOptions& object : motion.config.objects) {
    if (!object.takes_part || object.is_distractor) continue;
    if (const auto id = motion.frames->find(object.frame)) {
      frames.push_back({object.name, object.frame, *id, true});
    }
  }
  for (const scene::CameraRig& camera : motion.cameras) {
    const std::string frame = camera.neededFrame();
    if (!frame.empty()) frames.push_back({camera.name, frame, camera.followed});
  }
  return frames;
}

std::string hertz(double rate) { return fixed(rate, rate < 10.0 ? 2 : 0) + " Hz"; }

/// The shortest time between consecutive transforms of any of the frames.
std::optional<Duration> shortestRecorded(const MotionSetup& motion,
                                         const std::vector<FollowedFrame>& frames) {
  const auto& stamps = motion.timeline.stamps;
  std::optional<Duration> shortest;
  for (const FollowedFrame& frame : frames) {
    const auto period = motion.frames->recordedPeriod(frame.id, stamps[stamps.size() / 2]);
    if (period && (!shortest || *period < *shortest)) shortest = period;
  }
  return shortest;
}

void checkRate(const MotionSetup& motion, const std::vector<FollowedFrame>& frames,
               std::vector<Finding>& findings) {
  constexpr double kDense = 2.5;  // denser scenes show nothing new between two transforms but noise
  const auto recorded = shortestRecorded(motion, frames);
  if (!recorded || motion.timeline.stamps.size() < 2) return;
  if (motion.pictures) return;  // whose times are given
  const double rate = 1.0 / toSeconds(*recorded);
  if (motion.config.motion.rate < kDense * rate) return;
  findings.push_back(
      {"too dense", "simulated_rate",
       "makes " + hertz(motion.config.motion.rate) + " of a recording whose frames move at " +
           hertz(rate) + " at most: poses in between are interpolated, and scenes are nearly equal",
       "`simulated_rate: " + fixed(rate, rate < 10.0 ? 1 : 0) + "` or less"});
}

/// Whether a frame has the same pose at all of these times.
bool standsStill(const MotionSetup& motion, motion::FrameId frame,
                 const std::vector<std::size_t>& times) {
  const auto& stamps = motion.timeline.stamps;
  const auto first = motion.frames->pose(frame, stamps[times.front()]);
  return first && std::all_of(times.begin(), times.end(), [&](std::size_t i) {
           const auto pose = motion.frames->pose(frame, stamps[i]);
           return pose && isSamePlace(*first, *pose);
         });
}

/// Moving frames with the same prefix: those of a robot's base first, then by name.
std::vector<std::string> movingNeighbours(const MotionSetup& motion, const std::string& frame) {
  const std::string prefix = frame.substr(0, frame.rfind('/') + 1);
  if (prefix.empty()) return {};
  const std::vector<std::size_t> times = evenlySpread(motion.timeline.stamps.size(), 5);
  std::vector<std::string> bases;
  std::vector<std::string> others;
  for (const std::string& name : motion.frames->names().all()) {
    if (name == frame || name.rfind(prefix, 0) != 0) continue;
    const auto id = motion.frames->find(name);
    if (!id || !motion.frames->pose(*id, motion.timeline.stamps[times.front()])) continue;
    if (standsStill(motion, *id, times)) continue;
    (name.find("base_") != std::string::npos ? bases : others).push_back(name);
  }
  std::sort(bases.begin(), bases.end());
  std::sort(others.begin(), others.end());
  bases.insert(bases.end(), others.begin(), others.end());
  return bases;
}

/// Finds published frames that never move; frames that are static by design are fine.
void checkStandingStill(const MotionSetup& motion, const std::vector<FollowedFrame>& frames,
                        std::vector<Finding>& findings) {
  const auto& stamps = motion.timeline.stamps;
  const std::vector<std::size_t> times = evenlySpread(stamps.size(), 50);
  for (const FollowedFrame& frame : frames) {
    if (!frame.is_objects || times.size() < 2) continue;
    const bool is_static = !motion.frames->recordedPeriod(frame.id, stamps[stamps.size() / 2]);
    if (!standsStill(motion, frame.id, times)) continue;
    const std::vector<std::string> others = movingNeighbours(motion, frame.name);
    if (is_static && others.empty()) continue;
    findings.push_back(
        {"never moves", frame.owner,
         "its frame '" + frame.name + "' is " + (is_static ? "static" : "recorded") +
             ", and does not move in the " + fixed(toSeconds(stamps.back() - stamps.front()), 1) +
             " s of the run" +
             (others.empty() ? "" : ", while " + base::listed(others, 3) + " does"),
         others.empty()
             ? "`frame:` may need to name another frame, and global_frame the one it moves in; if "
               "it stands there on purpose, ignore this"
             : "`frame: " + others.front() +
                   "` follows that; if it stands there on purpose, ignore this"});
  }
}

/// Finds cameras that look into the sky because their frame is that of their body (x ahead, z up).
void checkOpticalFrames(const MotionSetup& motion, std::vector<Finding>& findings) {
  constexpr double kUpwards = 0.97;  // z of the optical axis: within 14 degrees
  const auto& stamps = motion.timeline.stamps;
  for (const scene::CameraRig& camera : motion.cameras) {
    if (!camera.followsFrame() || camera.X_FD) continue;
    const std::vector<std::size_t> times = evenlySpread(stamps.size(), 20);
    const bool looks_up = std::all_of(times.begin(), times.end(), [&](std::size_t i) {
      const auto X_GC = motion.frames->pose(camera.followed, stamps[i]);
      return X_GC && X_GC->linear()(2, 2) > kUpwards;
    });
    if (!looks_up) continue;
    findings.push_back(
        {"body frame", camera.name,
         "its frame '" + camera.frame +
             "' looks straight up all the time: it seems to be the frame of the camera's body (x "
             "ahead, z up), not the optical one (z ahead, y down) of REP 103",
         "the named frame should be the optical one, often '..._optical_frame'; if there is "
         "none, `correction: [0, 0, 0, -0.5, 0.5, -0.5, 0.5]` turns this one"});
  }
}

/// Whether randomization makes a scene differ from the previous one.
bool variesByItself(const MotionSetup& motion) {
  const randomize::Randomization& drawn = motion.config.randomization;
  const bool is_sampled =
      std::any_of(motion.cameras.begin(), motion.cameras.end(),
                  [](const scene::CameraRig& camera) { return camera.sampled; });
  return is_sampled || drawn.changesLook() || !drawn.objects.empty() || drawn.distractors ||
         drawn.weather.changesAir() || drawn.sensor.exposure || drawn.sensor.blur ||
         drawn.sensor.field_of_view || drawn.sensor.white_balance || drawn.sensor.jpeg_quality;
}

/// All followed frames, and those of links that move relative to their objects.
std::vector<motion::FrameId> allFrames(const MotionSetup& motion,
                                       const std::vector<FollowedFrame>& frames) {
  std::vector<motion::FrameId> ids;
  for (const FollowedFrame& frame : frames) ids.push_back(frame.id);
  for (const std::vector<scene::DrivenLinks>& object : motion.driven_links) {
    for (const scene::DrivenLinks& variant : object) {
      for (const scene::DrivenLink& link : variant) ids.push_back(link.frame);
    }
  }
  return ids;
}

void checkEqualScenes(const MotionSetup& motion, const std::vector<motion::FrameId>& frames,
                      std::vector<Finding>& findings) {
  constexpr double kMany = 0.5;  // share of all scenes: a robot may wait now and then
  const auto& stamps = motion.timeline.stamps;
  if (stamps.size() < 3 || variesByItself(motion)) return;
  const std::vector<std::size_t> befores = evenlySpread(stamps.size() - 1, 200);
  std::size_t equal = 0;
  for (const std::size_t i : befores) {
    const bool is_equal = std::all_of(frames.begin(), frames.end(), [&](motion::FrameId frame) {
      const auto before = motion.frames->pose(frame, stamps[i]);
      const auto after = motion.frames->pose(frame, stamps[i + 1]);
      return (!before && !after) || (before && after && isSamePlace(*before, *after));
    });
    equal += is_equal ? 1 : 0;
  }
  const double share = static_cast<double>(equal) / static_cast<double>(befores.size());
  if (share < kMany) return;
  findings.push_back({"equal scenes", "scenes",
                      "in " + fixed(100.0 * share, 0) +
                          " % of the scenes neither an object nor a camera has moved since the "
                          "scene before",
                      "`start_offset` and `duration` choose the part in which something moves, a "
                      "lower simulated_rate or randomize makes scenes differ"});
}

/// How a model's file specifies the scale of its meshes: URDF and SDF differ.
std::string scaleOf(const scene::ObjectOptions& object) {
  const std::string model = object.model.value_or("");
  const bool is_urdf = model.find(".urdf") != std::string::npos ||
                       model.find(".xacro") != std::string::npos ||
                       model.find("<robot") != std::string::npos;
  return is_urdf ? "the attribute `scale` of <mesh> in its URDF" : "<scale> of <mesh> in its file";
}

void checkObjectSizes(const MotionSetup& motion, std::vector<Finding>& findings) {
  constexpr double kLargest = 60.0;    // [m]; a jet or a crane
  constexpr double kSmallest = 0.004;  // [m]; a screw
  for (std::size_t i = 0; i < motion.config.objects.size(); ++i) {
    const scene::ObjectOptions& object = motion.config.objects[i];
    if (!object.takes_part || object.is_distractor || motion.variants[i].all().size() > 1) continue;
    const Eigen::Vector3d size = motion.shapes->boxesAtRest(i).front().size();
    const double largest = size.maxCoeff();
    if (largest >= kSmallest && largest <= kLargest) continue;
    const bool is_large = largest > kLargest;
    const int decimals = is_large ? 1 : 5;
    findings.push_back({"size", object.name,
                        "its model is " + fixed(size.x(), decimals) + " x " +
                            fixed(size.y(), decimals) + " x " + fixed(size.z(), decimals) + " m",
                        is_large ? "of a mesh in millimetres, " + scaleOf(object) +
                                       " should be "
                                       "`0.001 0.001 0.001`"
                                 : "its mesh may have been scaled twice: by " + scaleOf(object) +
                                       " and by the mesh's own unit"});
  }
}

}  // namespace

std::vector<Finding> checkSetup(const MotionSetup& motion) {
  std::vector<Finding> findings;
  checkObjectSizes(motion, findings);
  if (!motion.timeline.is_recorded || motion.timeline.stamps.empty()) return findings;
  const std::vector<FollowedFrame> frames = followedFrames(motion);
  checkRate(motion, frames, findings);
  checkStandingStill(motion, frames, findings);
  checkOpticalFrames(motion, findings);
  checkEqualScenes(motion, allFrames(motion, frames), findings);
  return findings;
}

void nameMotion(const MotionSetup& motion, std::size_t motion_count,
                std::vector<Finding>& findings) {
  if (motion_count == 1) return;
  for (Finding& each : findings) {
    each.about = "motion '" + motion.entry.name + "': " + each.about;
  }
}

}  // namespace synthetic_dataset::run
