#include "generator.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "config/settings_text.h"
#include "object_motion.h"
#include "open_output.h"
#include "picture_taker.h"
#include "random/random_seed.h"
#include "render/renderer.h"
#include "run_setup.h"
#include "scene_committer.h"
#include "scene_maker.h"
#include "seconds.h"
#include "synthetic_dataset/label_text.h"
#include "warning_teller.h"
#include "work_plan.h"

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

/// A scene that waits for what its optical flow needs.
struct UnwrittenScene {
  MadeScene made;
  render::PendingPicture image;
  std::vector<output::ContactFacts> contacts;
  std::vector<output::Warning> warnings;
  std::vector<output::DrawFacts> draws;
};

struct Generator::Impl {
  Impl(const Value& parameters, Reporter& user, const std::vector<std::string>& plugin_xml_files)
      : reporter(user),
        warnings(user),
        setup(setUpRun(parameters, plugin_xml_files)),
        renderer(setup.world->description(), setup.world->links(),
                 renderOptions(setup.config.rendering)),
        scene_maker(*setup.world, renderer, *setup.frames, setup.cameras, *setup.shapes,
                    *setup.splits, setup.writers->requirements(), labelOptions(setup.config)),
        picture_taker(*setup.world, renderer, *setup.frames, setup.cameras, setup.config.seed),
        object_motion(*setup.frames, setup.config, setup.world->links(), setup.driven_links),
        store(openOutput(describedSetup())),
        work(instantCount(), cameraCount(), shardOf(setup.config.output),
             setup.config.output.only_scenes, [this](std::int64_t scene) {
               return store->wasComplete() || store->hasScene(scene);
             }) {
    // A shutter may open before the recording begins: objects are where they are first seen then.
    const Stamp first = setup.timeline.stamps.front();
    (void)object_motion.objectPoses(first);
    motion_start = first + picture_taker.offsets().front();
    tellPlan();
  }

  /// The setup, with all that its manifest is to tell.
  [[nodiscard]] const RunSetup& describedSetup() {
    setup.description.software["opengl"] = renderer.glVersion();
    return setup;
  }

  [[nodiscard]] std::int64_t instantCount() const {
    return static_cast<std::int64_t>(setup.timeline.stamps.size());
  }
  [[nodiscard]] std::int64_t cameraCount() const {
    return static_cast<std::int64_t>(setup.cameras.size());
  }

  void tellPlan() {
    std::string defaults;
    for (const std::string& taken : setup.defaults_taken) {
      defaults += (defaults.empty() ? "" : ", ") + taken;
    }
    if (!defaults.empty()) reporter.info("defaults taken: " + defaults);
    for (const std::string& remark : setup.remarks) reporter.info(remark);
    warnings.tell(setup.description.warnings);
    reporter.info(std::to_string(setup.description.scene_count) + " scenes" + ofCameras() +
                  " from " + fixed(toSeconds(setup.timeline.stamps.front()), 3) + " s on, every " +
                  fixed(1.0 / setup.config.motion.rate, 4) + " s" + ofSplits() + ofShard() +
                  ofChoice());
    if (store->wasComplete()) {
      reporter.info("the dataset is complete already: there is nothing to do");
    } else if (work.missingCount() < work.sceneCount()) {
      reporter.info("going on: " + std::to_string(work.sceneCount() - work.missingCount()) +
                    " of these scenes are there already");
    }
  }

  [[nodiscard]] std::string ofSplits() const {
    std::string text;
    for (const SplitInfo& split : setup.splits->splits(setup.cameras.size())) {
      text += (text.empty() ? "; " : ", ") + split.name + " " + std::to_string(split.scene_count);
    }
    return text;
  }

  [[nodiscard]] std::string ofCameras() const {
    if (setup.cameras.size() == 1) return "";
    return " of " + std::to_string(setup.cameras.size()) + " cameras";
  }

  [[nodiscard]] std::string ofShard() const {
    const auto& shard = setup.config.output.shard;
    if (!shard) return "";
    return "; shard " + std::to_string(shard->index) + " of 0 to " +
           std::to_string(shard->count - 1) + " makes " + std::to_string(work.sceneCount());
  }

  [[nodiscard]] std::string ofChoice() const {
    if (setup.config.output.only_scenes.empty()) return "";
    return "; only_scenes makes " + std::to_string(work.sceneCount()) +
           ", and leaves the dataset open for the others";
  }

  void moveWorld(Stamp stamp) {
    setup.world->advanceTo(
        // While things settle, the objects stand where they start.
        stamp, [this](int object, Stamp time) {
          return object_motion.at(object, std::max(time, motion_start));
        });
    for (const std::string& gap : object_motion.takeGaps()) news.push_back({gap});
  }

  /// All that was drawn for a camera's scene.
  [[nodiscard]] std::vector<output::DrawFacts> drawsOf(std::size_t camera) const {
    std::vector<output::DrawFacts> draws = setup.variation->draws(camera);
    if (const auto& numbers = setup.arranger->distractors()) {
      Value::List there;
      for (const int number : *numbers) there.emplace_back(number);
      draws.push_back({"distractors", config::jsonText(Value(there))});
    }
    return draws;
  }

  void settle() {
    if (setup.arranger->standsAlone()) return;  // it has done so
    const Duration time = fromSeconds(setup.config.physics.settle);
    if (time.count() > 0) moveWorld(motion_start - std::min(time, motion_start - Stamp(1)));
  }

  /// Objects that are inside something now; each a warning, too.
  [[nodiscard]] std::vector<output::ContactFacts> findContacts(Stamp stamp) {
    std::vector<output::ContactFacts> contacts;
    for (const world::Interpenetration& pair : setup.world->interpenetrations()) {
      contacts.push_back({pair.first, pair.second, pair.depth});
      news.push_back({"'" + pair.first + "' and '" + pair.second + "' are inside one another",
                      "by " + fixed(pair.depth, 3) + " m at " + fixed(toSeconds(stamp), 3) + " s"});
    }
    return contacts;
  }

  void makeScenes() {
    reporter.progress(0, work.missingCount());
    settle();
    std::int64_t instant = 0;
    for (const Stamp stamp : setup.timeline.stamps) {
      if (!work.hasWorkFrom(instant) && unwritten.empty()) break;
      if (reporter.stopRequested()) {
        summary.stopped = true;
        break;
      }
      makeInstant(instant++, stamp);
    }
    if (!summary.stopped) write(std::nullopt);
    committer.finish();
    tellWritten();
  }

  /// The scenes of one time: one a camera. Where none of them is to be made, the world goes through
  /// this time all the same: what props do and where links were last seen follows from it.
  void makeInstant(std::int64_t instant, Stamp stamp) {
    const bool stands_alone = setup.arranger->standsAlone();
    if (stands_alone && !work.wants(instant)) return;
    std::vector<UnwrittenScene> scenes;
    arrange(instant, stamp);
    for (const Duration offset : picture_taker.offsets()) {
      moveWorld(stamp + offset);
      if (work.wants(instant)) picture_taker.expose(stamp, offset);
      if (offset != Duration{0}) continue;
      write(stamp);
      if (work.wants(instant)) scenes = lookAtInstant(instant, stamp);
    }
    for (UnwrittenScene& each : scenes) {
      const Scene& scene = each.made.scene;
      each.image = picture_taker.develop(scene.camera_index, scene.index);
    }
    // What a time brought to light is told with its first scene.
    if (!scenes.empty()) scenes.front().warnings = std::move(news);
    news.clear();
    unwritten = std::move(scenes);
    if (stands_alone || !scene_maker.needsOpticalFlow()) write(std::nullopt);
  }

  /// Puts everything that is put somewhere for each scene, at the time when the first shutter
  /// opens.
  void arrange(std::int64_t instant, Stamp stamp) {
    setup.variation->choose(instant, *setup.world);
    setup.arranger->placeObjects(instant);
    moveWorld(stamp + picture_taker.offsets().front());
    // The scene before may wait for where things have gone.
    if (!work.wants(instant) && unwritten.empty()) return;
    setup.arranger->placeDistractors(instant, stamp);
    setup.arranger->placeCameras(instant, stamp);
    setup.variation->vary(instant, renderer, setup.cameras);
  }

  [[nodiscard]] std::vector<UnwrittenScene> lookAtInstant(std::int64_t instant, Stamp stamp) {
    std::vector<UnwrittenScene> scenes;
    const std::vector<Pose> X_GO = object_motion.objectPoses(stamp);
    for (std::size_t camera = 0; camera < setup.cameras.size(); ++camera) {
      scenes.push_back(
          {scene_maker.make(camera, instant, stamp, X_GO), {}, {}, {}, drawsOf(camera)});
    }
    scenes.front().contacts = findContacts(stamp);
    return scenes;
  }

  /// Writes the scenes that were made last.
  /// @param now  where the world stands, for where their pixels have gone; nothing after the last
  void write(std::optional<Stamp> now) {
    for (UnwrittenScene& each : unwritten) {
      if (!work.lacks(each.made.scene.index)) continue;  // of another camera than those missing
      if (scene_maker.needsOpticalFlow()) scene_maker.addOpticalFlow(each.made, now);
      output::SceneFacts facts = factsOf(each);
      committer.add(std::move(each.made.scene), std::move(each.image), std::move(facts));
    }
    unwritten.clear();
    tellWritten();
  }

  /// The reporter hears of scenes in the thread that runs.
  void tellWritten() {
    for (const std::vector<output::Warning>& of_scene : committer.takeCommitted()) {
      warnings.tell(of_scene);
      reporter.progress(++summary.scenes, work.missingCount());
    }
  }

  [[nodiscard]] output::SceneFacts factsOf(const UnwrittenScene& each) const {
    const Scene& scene = each.made.scene;
    output::SceneFacts facts = output::sceneFacts(scene);
    facts.seed =
        random::randomSeed(static_cast<std::uint64_t>(setup.config.seed), scene.index, "scene");
    facts.objects = scene_maker.objectFacts(each.made);
    facts.contacts = each.contacts;
    facts.warnings = each.warnings;
    facts.draws = each.draws;
    return facts;
  }

  /// What the whole dataset holds, for the run's last words.
  void summarize() {
    summary.dataset_scenes = store->counts().scenes;
    summary.planned_scenes = work.sceneCount();
    summary.files = store->counts().files;
    summary.bytes = store->counts().bytes;
    summary.warnings = store->warningCounts();
    const std::vector<output::ObjectCounts> counts = store->objectCounts();
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const output::ObjectCounts& of = counts[i];
      summary.objects.push_back(
          {setup.config.objects[i].name, of.in_view, of.seen, of.dropped, std::nullopt});
      if (of.compared > 0) summary.objects.back().mask_agreement = of.mean_mask_agreement;
    }
  }

  Reporter& reporter;
  WarningTeller warnings;
  RunSetup setup;
  render::Renderer renderer;
  SceneMaker scene_maker;
  PictureTaker picture_taker;
  ObjectMotion object_motion;
  Stamp motion_start{0};                  ///< when the first shutter opens
  std::vector<output::Warning> news;      ///< since the last instant
  std::vector<UnwrittenScene> unwritten;  ///< the last time's, while they wait for the next one
  std::unique_ptr<output::DatasetStore> store;  // late: what fails before leaves the disk alone
  WorkPlan work;
  RunSummary summary;
  SceneCommitter committer{*setup.writers, *store};  // last: its thread uses some of the above
};

Generator::Generator(const Value& parameters, Reporter& reporter,
                     const std::vector<std::string>& plugin_xml_files)
    : impl_(std::make_unique<Impl>(parameters, reporter, plugin_xml_files)) {}

Generator::~Generator() = default;

RunSummary Generator::run() {
  RunSummary& summary = impl_->summary;
  output::DatasetStore& store = *impl_->store;
  summary.manifest = store.manifestPath();
  summary.was_complete = store.wasComplete();
  if (summary.was_complete) return summary;
  const auto begin = std::chrono::steady_clock::now();
  impl_->makeScenes();
  if (summary.stopped || !impl_->setup.config.output.only_scenes.empty()) {
    store.flush();
  } else {
    // The files of the dataset as a whole are made of all shards together, when they are merged.
    if (!impl_->setup.config.output.shard) impl_->setup.writers->finalize(store);
    store.complete();
  }
  summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  impl_->summarize();
  return summary;
}

}  // namespace synthetic_dataset
