#include "run/motion_run.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <utility>

#include "base/json_text.h"
#include "base/random/random_seed.h"
#include "base/seconds.h"
#include "run/world_history.h"
#include "scene/recorded_comparison.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::run {
namespace {

/// Adds what is needed for the comparison with recorded pictures.
Requirements labelRequirements(Requirements requirements, const MotionSetup& motion) {
  if (motion.pictures) requirements.visible_masks = true;
  return requirements;
}

label::PixelLabelOptions labelOptions(const MotionSetup& motion) {
  const config::Config& config = motion.config;
  label::PixelLabelOptions options{
      config.masks, config.labels, {}, motion.world_classes, motion.parts};
  if (motion.surfaces) options.occlusion = config.twin.margin;
  for (const scene::ObjectOptions& object : config.objects) {
    const auto found =
        std::find_if(config.classes.begin(), config.classes.end(),
                     [&](const config::ClassConfig& each) { return each.id == object.class_id; });
    options.class_numbers.push_back(static_cast<std::uint16_t>(found - config.classes.begin() + 1));
  }
  return options;
}

/// Merges two ascending lists of times.
std::vector<Duration> bothOf(const std::vector<Duration>& one, const std::vector<Duration>& other) {
  std::vector<Duration> both;
  std::set_union(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(both));
  return both;
}

/// The labels of what a lidar's rays hit, by the world's links.
std::vector<lidar::LinkLabel> linkLabels(const MotionSetup& motion) {
  const std::vector<std::uint16_t> classes = labelOptions(motion).class_numbers;
  std::vector<lidar::LinkLabel> labels;
  for (const world::LinkInstance& link : motion.world->links()) {
    lidar::LinkLabel& label = labels.emplace_back();
    const std::size_t index = labels.size() - 1;
    label.world_class = motion.world_classes[index];
    label.part = motion.parts[index];
    if (link.object < 0) continue;
    label.instance = static_cast<std::uint16_t>(link.object + 1);
    label.class_number = classes[static_cast<std::size_t>(link.object)];
  }
  return labels;
}

/// Warns of objects in view that are not drawn because they are beyond the camera's far limit.
void warnOfFar(const Scene& scene, std::vector<base::Warning>& warnings) {
  for (const SceneObject& object : scene.objects) {
    if (!object.X_CO || !object.inView(scene.camera)) continue;
    const double radius = 0.5 * object.cuboid_O.size().norm();
    const double nearest = (*object.X_CO * object.cuboid_O.centre()).z() - radius;
    if (nearest <= scene.camera.far()) continue;
    warnings.push_back({"'" + object.name + "' is in view, and beyond camera/far, " +
                            fixed(scene.camera.far(), 0) + " m: nothing of it is drawn",
                        "in scene '" + scene.name + "' it is " + fixed(nearest, 0) + " m away"});
  }
}

}  // namespace

MotionRun::MotionRun(MotionSetup& motion, const SplitPlan& splits, const Requirements& requirements)
    : motion_(motion),
      splits_(splits),
      renderer_(motion.world->description(), motion.world->links(), motion.config.rendering),
      scene_maker_(*motion.world, renderer_, *motion.frames, motion.cameras, *motion.shapes,
                   labelRequirements(requirements, motion), labelOptions(motion)),
      picture_taker_(*motion.world, renderer_, motion.cameras, motion.config.seed),
      row_recorder_(*motion.world, motion.cameras, motion.config.labels.follows_rows),
      offsets_(bothOf(picture_taker_.offsets(), row_recorder_.offsets())),
      object_motion_(*motion.frames, motion.config.objects, motion.world->links(),
                     motion.driven_links),
      physics_findings_(*motion.world, motion.config.physics.contact_tolerance) {
  if (requirements.clouds) makeSweepTaker();
  // A shutter may open before the recording begins; until then objects are where they are first
  // seen.
  const Stamp first = motion_.timeline.stamps.front();
  (void)object_motion_.objectPoses(first);
  motion_start_ = first + offsetsAt(first).front();
}

void MotionRun::makeSweepTaker() {
  if (motion_.lidars.empty()) return;
  sweep_taker_.emplace(*motion_.world, *motion_.frames, motion_.lidars, linkLabels(motion_),
                       motion_.config.rendering.glass_in_labels, motion_.config.seed);
}

/// The offsets from an instant at which the world is observed; ascending.
std::vector<Duration> MotionRun::offsetsAt(Stamp stamp) const {
  return sweep_taker_ ? bothOf(offsets_, sweep_taker_->offsets(stamp)) : offsets_;
}

bool MotionRun::run(const WorkPlan& work, ScenePipeline& pipeline, Reporter& reporter) {
  std::int64_t instant = motion_.first_instant;
  const std::int64_t end = work.endOfWork(instant + motion_.instantCount());
  follows_history_ = historyCovers(end);
  reporter.stage("letting physics settle");
  settle();
  reporter.stage("drawing the first scene");
  for (const Stamp stamp : motion_.timeline.stamps) {
    if (instant >= end && drawn_.empty()) break;
    if (reporter.stopRequested()) return false;
    makeInstant(instant++, stamp, work, pipeline);
  }
  addOpticalFlow(nullptr);
  passOn(pipeline);
  return true;
}

/// Whether the history covers the world's state up to `end`, before which all wanted instants lie.
bool MotionRun::historyCovers(std::int64_t end) const {
  const bool may_be = motion_.history && !motion_.arranger->standsAlone() &&
                      !scene_maker_.needsOpticalFlow() && end > motion_.first_instant;
  if (!may_be) return false;
  const auto last = static_cast<std::size_t>(end - 1 - motion_.first_instant);
  const Stamp stamp = motion_.timeline.stamps[last];
  return motion_.history->reaches(stamp + offsetsAt(stamp).back());
}

void MotionRun::settle() {
  if (motion_.arranger->standsAlone() || follows_history_) return;  // already settled
  const Duration time = motion_.config.settling;
  if (time.count() == 0) return;
  motion_.variation->choose(motion_.first_instant, *motion_.world);  // for the first variants
  moveWorld(motion_start_ - std::min(time, motion_start_ - Stamp(1)));
}

void MotionRun::moveWorld(Stamp stamp) {
  const WorldHistory::Moment* known = follows_history_ ? motion_.history->find(stamp) : nullptr;
  if (known == nullptr) {
    advanceWorld(stamp);
  } else {
    motion_.world->showAt(stamp, known->X_WM, known->X_WO);
  }
  motion_.arranger->followProps();
}

void MotionRun::advanceWorld(Stamp stamp) {
  // Physics only moves forward; recorded sweeps may overlap a little (run/setup/recorded_scenes.h).
  if (!motion_.arranger->standsAlone() && !motion_.world->propPoses().empty()) {
    stamp = reached_ = std::max(reached_, stamp);
  }
  const auto poseAt = [this](int moving_object, Stamp time) {
    // While things settle, the objects stand where they start.
    return object_motion_.at(moving_object, std::max(time, motion_start_));
  };
  motion_.world->advanceTo(stamp, poseAt);
  if (motion_.history) {
    WorldHistory::Moment moment{motion_.world->propPoses(), {}};
    int variant = 0;
    for (const std::vector<scene::DrivenLinks>& object : motion_.driven_links) {
      for (std::size_t i = 0; i < object.size(); ++i) {
        moment.X_WO.push_back(poseAt(variant++, stamp));
      }
    }
    motion_.history->add(stamp, std::move(moment));
  }
}

/// Makes the scenes of one instant, one per camera. If none of them is wanted, the world still
/// passes through this instant, as the props' motion and the links' last known poses depend on it.
void MotionRun::makeInstant(std::int64_t instant, Stamp stamp, const WorkPlan& work,
                            ScenePipeline& pipeline) {
  const bool stands_alone = motion_.arranger->standsAlone();
  const bool is_wanted = work.hasInstant(instant);
  if ((stands_alone || follows_history_) && !is_wanted) return;
  // Scenes that need not wait are passed on one by one, as their images take much memory.
  const bool waits_for_next = scene_maker_.needsOpticalFlow() && !stands_alone;
  const std::vector<Duration> offsets = offsetsAt(stamp);
  const bool waits = waits_for_next || offsets.size() > 1;
  std::vector<DrawnScene> scenes;
  lidar::PendingClouds clouds;
  const auto develop = [&] {
    if (sweep_taker_ && !clouds) {
      clouds = sweep_taker_->take(instant, motion_.variation->materials());
    }
    for (DrawnScene& each : scenes) {
      each.clouds = clouds;
      const Scene& scene = each.seen.scene;
      if (motion_.config.hasRecordedImages()) continue;  // read when the scene is finished
      each.image = picture_taker_.develop(scene.camera_index, scene.index);
    }
    // The instant's first scene receives all warnings since the previous instant.
    for (const std::string& gap : object_motion_.takeGaps()) pending_warnings_.push_back({gap});
    if (!scenes.empty()) scenes.front().warnings = std::exchange(pending_warnings_, {});
    for (DrawnScene& each : scenes) {
      if (work.hasScene(each.seen.scene.index)) drawn_.push_back(std::move(each));
    }
    scenes.clear();
    if (waits_for_next) return;
    addOpticalFlow(nullptr);
    passOn(pipeline);
  };
  arrange(instant, stamp, offsets.front(), is_wanted);
  const bool records_rows = row_recorder_.followsAny() && (is_wanted || !drawn_.empty());
  if (sweep_taker_) sweep_taker_->begin(stamp);
  for (const Duration offset : offsets) {
    moveWorld(stamp + offset);
    if (is_wanted && sweep_taker_) sweep_taker_->look(offset);
    scene::CameraPoses poses(motion_.cameras, *motion_.world, *motion_.frames, stamp, offset);
    if (offset == Duration{0}) {
      addOpticalFlow(&poses);
      if (!records_rows) passOn(pipeline);
    }
    std::vector<std::optional<Pose>> X_GO;
    if (records_rows || (is_wanted && offset == Duration{0})) {
      X_GO = object_motion_.objectPoses(stamp + offset);
    }
    for (std::size_t camera = 0; camera < motion_.cameras.size(); ++camera) {
      if (records_rows) row_recorder_.record(camera, offset, poses, X_GO);
      if (!is_wanted) continue;
      if (!motion_.config.hasRecordedImages()) picture_taker_.expose(camera, offset, poses);
      if (offset == Duration{0}) scenes.push_back(look(camera, instant, stamp, poses, X_GO));
      if (!waits) develop();
    }
  }
  if (records_rows) {
    lookInRows(scenes);
    passOn(pipeline);
  }
  if (waits) develop();
  pending_warnings_.clear();
  (void)object_motion_.takeGaps();  // of an instant without scenes
}

/// Places everything that is placed per scene, at the time when the first shutter opens.
/// @param first  the earliest of the offsets from the instant
void MotionRun::arrange(std::int64_t instant, Stamp stamp, Duration first, bool is_wanted) {
  motion_.variation->choose(instant, *motion_.world);
  motion_.arranger->placeObjects(instant);
  moveWorld(stamp + first);
  // The previous scene may be waiting to learn where things have moved.
  if (!is_wanted && drawn_.empty()) return;
  motion_.arranger->placeDistractors(instant, stamp);
  for (base::Warning& each : motion_.arranger->placeCameras(instant, stamp)) {
    pending_warnings_.push_back(std::move(each));
  }
  motion_.variation->vary(instant, renderer_, motion_.cameras);
}

MotionRun::DrawnScene MotionRun::look(std::size_t camera, std::int64_t instant, Stamp stamp,
                                      scene::CameraPoses& poses,
                                      const std::vector<std::optional<Pose>>& X_GO) {
  std::map<std::string, Pose> X_GF;
  if (!motion_.lidars.empty())
    X_GF = lidar::posesOf(motion_.lidars, *motion_.world, *motion_.frames, stamp);
  DrawnScene scene{row_recorder_.follows(camera)
                       ? scene_maker_.begin(camera, instant, stamp, poses, X_GO, X_GF)
                       : scene_maker_.look(camera, instant, stamp, poses, X_GO, X_GF),
                   {},
                   {},
                   {},
                   {},
                   {},
                   drawsOf(camera, instant)};
  scene.seen.scene.split = splits_.at(instant);
  warnOfFar(scene.seen.scene, pending_warnings_);
  if (motion_.surfaces) {
    scene.measured = motion_.surfaces->seenBy(camera, *motion_.world, stamp, scene.seen.scene.X_GC);
  }
  if (camera == 0) {
    scene.contacts = physics_findings_.contacts(stamp, pending_warnings_);
    physics_findings_.addFallen(stamp, pending_warnings_);
  }
  return scene;
}

/// All randomization draws made for a camera's scene.
std::vector<base::DrawFacts> MotionRun::drawsOf(std::size_t camera, std::int64_t instant) const {
  std::vector<base::DrawFacts> draws = motion_.variation->draws(camera);
  if (const auto& jitter = motion_.timeline.jitter; !jitter.empty()) {
    const auto index = static_cast<std::size_t>(instant - motion_.first_instant);
    draws.push_back({"time/jitter", base::jsonText(Value(toSeconds(jitter[index])))});
  }
  if (const auto& numbers = motion_.arranger->distractors()) {
    Value::List there;
    for (const int number : *numbers) there.emplace_back(number);
    draws.push_back({"distractors", base::jsonText(Value(there))});
  }
  return draws;
}

/// Labels the scenes of rolling shutters, now that all poses at their rows' times are known.
/// @param scenes  of this instant; empty if it is not wanted
void MotionRun::lookInRows(std::vector<DrawnScene>& scenes) {
  for (std::size_t camera = 0; camera < motion_.cameras.size(); ++camera) {
    if (!row_recorder_.follows(camera)) continue;
    label::CapturedRows taken = row_recorder_.take(camera);
    for (DrawnScene& before : drawn_) {
      if (scene_maker_.needsOpticalFlow() && before.seen.scene.camera_index == camera) {
        scene::SceneMaker::addOpticalFlowInRows(before.seen, taken.view);
      }
    }
    if (!scenes.empty()) scene_maker_.lookInRows(scenes[camera].seen, std::move(taken));
  }
}

/// Adds the optical flow to the scenes that were drawn last.
/// @param now  the cameras' current poses, which leaves out rolling shutters, whose flow
///     lookInRows() adds; null if no next scene is awaited
void MotionRun::addOpticalFlow(scene::CameraPoses* now) {
  if (!scene_maker_.needsOpticalFlow()) return;
  for (DrawnScene& each : drawn_) {
    const bool is_known = now == nullptr || !row_recorder_.follows(each.seen.scene.camera_index);
    if (is_known) scene_maker_.addOpticalFlow(each.seen, now);
  }
}

/// Passes on the scenes that were drawn last.
void MotionRun::passOn(ScenePipeline& pipeline) {
  for (DrawnScene& each : drawn_) {
    const CameraModel& camera = each.seen.scene.camera;
    const std::int64_t pixel_count = std::int64_t{camera.width()} * camera.height();
    // Begins while the previous scene's labels are being determined, as neither keeps all cores
    // busy. Background subtraction does: its pictures would only wait longer (10 % of a scene).
    if (each.image && motion_.config.masks.method != label::MaskMethod::kMog2) {
      each.image = renderer_.makers().begun(std::move(each.image));
    }
    pipeline.add(
        [this, drawn = std::make_shared<DrawnScene>(std::move(each))] { return finish(*drawn); },
        pixel_count);
  }
  drawn_.clear();
}

FinishedScene MotionRun::finish(DrawnScene& drawn) const {
  Scene& scene = drawn.seen.scene;
  drawn.seen.X_GL.clear();
  drawn.seen.rows.reset();
  drawn.seen.pixels.surface = {};
  // The inputs of labels and image are released once used.
  const cv::Mat measured = drawn.measured ? std::exchange(drawn.measured, {})() : cv::Mat();
  const label::LabelFindings findings =
      std::exchange(drawn.seen.pixels.labels, {})(scene, measured);
  scene::TakenPicture recorded;
  if (motion_.pictures) recorded = motion_.pictures->take(scene.camera_index, scene.stamp);
  if (drawn.clouds) {
    lidar::TakenClouds taken = std::exchange(drawn.clouds, {})();
    scene.clouds = std::move(taken.clouds);
    if (scene.camera_index == 0) {  // all cameras of an instant have the same clouds
      std::move(taken.warnings.begin(), taken.warnings.end(), std::back_inserter(drawn.warnings));
    }
  }
  const bool is_recorded = motion_.config.hasRecordedImages();
  scene.image = is_recorded ? recorded.pixels : std::exchange(drawn.image, {})();
  picture_taker_.measureDepth(scene);  // after the labels, which need the exact depth
  base::SceneFacts facts = factsOf(drawn, findings.agreement);
  FinishedScene finished{std::move(scene), std::move(facts)};
  if (motion_.pictures) {
    scene::compareWithRecorded(recorded.pixels, finished.scene, finished.facts);
    finished.is_left_out =
        scene::isBelowAlignment(motion_.config.twin.min_alignment, finished.facts);
    scene::addCovers(findings.covers, finished.scene, finished.facts);
  }
  if (is_recorded) finished.image_file = std::move(recorded.jpeg);
  return finished;
}

base::SceneFacts MotionRun::factsOf(const DrawnScene& drawn,
                                    const label::MaskAgreement& agreement) const {
  const Scene& scene = drawn.seen.scene;
  base::SceneFacts facts = base::sceneFacts(scene);
  facts.seed =
      base::randomSeed(static_cast<std::uint64_t>(motion_.config.seed), scene.index, "scene");
  facts.objects = scene_maker_.objectFacts(scene, agreement);
  facts.contacts = drawn.contacts;
  facts.warnings = drawn.warnings;
  facts.draws = drawn.draws;
  return facts;
}

}  // namespace synthetic_dataset::run
