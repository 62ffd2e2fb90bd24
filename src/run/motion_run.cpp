#include "run/motion_run.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "config/settings_text.h"
#include "random/random_seed.h"
#include "scene/seconds.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {
namespace {

render::RenderOptions renderOptions(const config::RenderingConfig& config) {
  return {config.samples, config.shadow_map_size, config.shadow_distance, config.reuse};
}

PixelLabelOptions labelOptions(const config::Config& config) {
  PixelLabelOptions options{config.masks, config.labels, {}};
  for (const config::ObjectConfig& object : config.objects) {
    const auto place =
        std::find_if(config.classes.begin(), config.classes.end(),
                     [&](const config::ClassConfig& each) { return each.id == object.class_id; });
    options.class_numbers.push_back(static_cast<std::uint16_t>(place - config.classes.begin() + 1));
  }
  return options;
}

}  // namespace

MotionRun::MotionRun(const RunSetup& setup, MotionSetup& motion, Sink sink)
    : motion_(motion),
      splits_(*setup.splits),
      sink_(std::move(sink)),
      renderer_(motion.world->description(), motion.world->links(),
                renderOptions(motion.config.rendering)),
      scene_maker_(*motion.world, renderer_, *motion.frames, motion.cameras, *motion.shapes,
                   setup.writers->requirements(), labelOptions(motion.config)),
      picture_taker_(*motion.world, renderer_, *motion.frames, motion.cameras, motion.config.seed),
      object_motion_(*motion.frames, motion.config, motion.world->links(), motion.driven_links) {
  // A shutter may open before the recording begins: objects are where they are first seen then.
  const Stamp first = motion_.timeline.stamps.front();
  (void)object_motion_.objectPoses(first);
  motion_start_ = first + picture_taker_.offsets().front();
}

bool MotionRun::run(const WorkPlan& work, const std::function<bool()>& is_told_to_stop) {
  settle();
  const std::int64_t begin = motion_.first_instant;
  const std::int64_t end = work.endOfWork(begin + motion_.instantCount());
  std::int64_t instant = begin;
  for (const Stamp stamp : motion_.timeline.stamps) {
    if (instant >= end && unwritten_.empty()) break;
    if (is_told_to_stop()) return false;
    makeInstant(instant++, stamp, work);
  }
  write(std::nullopt, work);
  return true;
}

void MotionRun::settle() {
  if (motion_.arranger->standsAlone()) return;  // it has done so
  const Duration time = fromSeconds(motion_.config.physics.settle);
  if (time.count() == 0) return;
  motion_.variation->choose(motion_.first_instant, *motion_.world);  // about what is worn first
  moveWorld(motion_start_ - std::min(time, motion_start_ - Stamp(1)));
}

void MotionRun::moveWorld(Stamp stamp) {
  motion_.world->advanceTo(
      // While things settle, the objects stand where they start.
      stamp, [this](int moving_object, Stamp time) {
        return object_motion_.at(moving_object, std::max(time, motion_start_));
      });
  for (const std::string& gap : object_motion_.takeGaps()) news_.push_back({gap});
}

/// The scenes of one time: one a camera. Where none of them is to be made, the world goes through
/// this time all the same: what props do and where links were last seen follows from it.
void MotionRun::makeInstant(std::int64_t instant, Stamp stamp, const WorkPlan& work) {
  const bool stands_alone = motion_.arranger->standsAlone();
  const bool is_wanted = work.wants(instant);
  if (stands_alone && !is_wanted) return;
  // Scenes that wait for nothing are passed on one by one, as their pictures take much memory.
  const bool waits_for_next = scene_maker_.needsOpticalFlow() && !stands_alone;
  const bool waits = waits_for_next || picture_taker_.offsets().size() > 1;
  std::vector<UnwrittenScene> scenes;
  const auto develop = [&] {
    for (UnwrittenScene& each : scenes) {
      const Scene& scene = each.seen.scene;
      each.image = picture_taker_.develop(scene.camera_index, scene.index);
    }
    // Warnings go to the instant's first scene.
    if (!scenes.empty()) scenes.front().warnings = std::exchange(news_, {});
    unwritten_ = std::exchange(scenes, {});
    if (!waits_for_next) write(std::nullopt, work);
  };
  arrange(instant, stamp, is_wanted);
  for (const Duration offset : picture_taker_.offsets()) {
    moveWorld(stamp + offset);
    std::vector<Pose> X_GO;
    if (offset == Duration{0}) {
      write(stamp, work);
      if (is_wanted) X_GO = object_motion_.objectPoses(stamp);
    }
    for (std::size_t camera = 0; is_wanted && camera < motion_.cameras.size(); ++camera) {
      picture_taker_.expose(camera, stamp, offset);
      if (offset == Duration{0}) scenes.push_back(look(camera, instant, stamp, X_GO));
      if (!waits) develop();
    }
  }
  if (waits) develop();
  news_.clear();
}

/// Puts everything that is put somewhere for each scene, at the time when the first shutter opens.
void MotionRun::arrange(std::int64_t instant, Stamp stamp, bool is_wanted) {
  motion_.variation->choose(instant, *motion_.world);
  motion_.arranger->placeObjects(instant);
  moveWorld(stamp + picture_taker_.offsets().front());
  // The scene before may wait for where things have gone.
  if (!is_wanted && unwritten_.empty()) return;
  motion_.arranger->placeDistractors(instant, stamp);
  motion_.arranger->placeCameras(instant, stamp);
  motion_.variation->vary(instant, renderer_, motion_.cameras);
}

MotionRun::UnwrittenScene MotionRun::look(std::size_t camera, std::int64_t instant, Stamp stamp,
                                          const std::vector<Pose>& X_GO) {
  UnwrittenScene scene{
      scene_maker_.look(camera, instant, stamp, X_GO), {}, {}, {}, drawsOf(camera, instant)};
  scene.seen.scene.split = splits_.at(instant);
  if (camera == 0) scene.contacts = findContacts(stamp);
  return scene;
}

/// All that was drawn for a camera's scene.
std::vector<output::DrawFacts> MotionRun::drawsOf(std::size_t camera, std::int64_t instant) const {
  std::vector<output::DrawFacts> draws = motion_.variation->draws(camera);
  if (const auto& jitter = motion_.timeline.jitter; !jitter.empty()) {
    const auto place = static_cast<std::size_t>(instant - motion_.first_instant);
    draws.push_back({"time/jitter", config::jsonText(Value(toSeconds(jitter[place])))});
  }
  if (const auto& numbers = motion_.arranger->distractors()) {
    Value::List there;
    for (const int number : *numbers) there.emplace_back(number);
    draws.push_back({"distractors", config::jsonText(Value(there))});
  }
  return draws;
}

/// Objects that are inside something now; each a warning, too.
std::vector<output::ContactFacts> MotionRun::findContacts(Stamp stamp) {
  std::vector<output::ContactFacts> contacts;
  for (const world::Interpenetration& pair : motion_.world->interpenetrations()) {
    contacts.push_back({pair.first, pair.second, pair.depth});
    news_.push_back({"'" + pair.first + "' and '" + pair.second + "' are inside one another",
                     "by " + fixed(pair.depth, 3) + " m at " + fixed(toSeconds(stamp), 3) + " s"});
  }
  return contacts;
}

/// Hands over the scenes that were made last.
/// @param now  where the world stands, for where their pixels have gone; nothing after the last
void MotionRun::write(std::optional<Stamp> now, const WorkPlan& work) {
  for (UnwrittenScene& each : unwritten_) {
    if (!work.lacks(each.seen.scene.index)) continue;  // of another camera than those missing
    if (scene_maker_.needsOpticalFlow()) scene_maker_.addOpticalFlow(each.seen, now);
    sink_([this, unfinished = std::make_shared<UnwrittenScene>(std::move(each))] {
      return finish(*unfinished);
    });
  }
  unwritten_.clear();
}

FinishedScene MotionRun::finish(UnwrittenScene& each) const {
  Scene& scene = each.seen.scene;
  each.seen.X_GL.clear();
  each.seen.pixels.surface = {};
  // What labels and picture are made of is not needed any more.
  const MaskAgreement agreement = std::exchange(each.seen.pixels.labels, {})(scene);
  scene.image = std::exchange(each.image, {})();
  output::SceneFacts facts = factsOf(each, agreement);
  return {std::move(scene), std::move(facts)};
}

output::SceneFacts MotionRun::factsOf(const UnwrittenScene& each,
                                      const MaskAgreement& agreement) const {
  const Scene& scene = each.seen.scene;
  output::SceneFacts facts = output::sceneFacts(scene);
  facts.seed =
      random::randomSeed(static_cast<std::uint64_t>(motion_.config.seed), scene.index, "scene");
  facts.objects = scene_maker_.objectFacts(scene, agreement);
  facts.contacts = each.contacts;
  facts.warnings = each.warnings;
  facts.draws = each.draws;
  return facts;
}

}  // namespace synthetic_dataset
