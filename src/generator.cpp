#include "generator.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "object_motion.h"
#include "picture_taker.h"
#include "render/renderer.h"
#include "run_setup.h"
#include "scene_maker.h"
#include "seconds.h"
#include "synthetic_dataset/label_text.h"
#include "warning_counter.h"

namespace synthetic_dataset {
namespace {

render::RenderOptions renderOptions(const config::RenderingConfig& config) {
  return {config.samples, config.shadow_map_size, config.shadow_distance};
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

struct Generator::Impl {
  Impl(const Value& parameters, Reporter& user, const std::vector<std::string>& plugin_xml_files)
      : reporter(user),
        warnings(user),
        setup(setUpRun(parameters, plugin_xml_files)),
        renderer(setup.world->description(), setup.world->links(),
                 renderOptions(setup.config.rendering)),
        scene_maker(*setup.world, renderer, *setup.recording, setup.cameras,
                    setup.config.global_frame, *setup.shapes, *setup.splits,
                    setup.writers->requirements(), labelOptions(setup.config)),
        picture_taker(*setup.world, renderer, *setup.recording, setup.cameras,
                      setup.config.global_frame, setup.config.seed),
        object_motion(*setup.recording, setup.config, setup.world->links(), setup.driven_links),
        store(openOutput(setup)) {
    for (const config::ObjectConfig& object : setup.config.objects) {
      summary.objects.push_back({object.name, 0, 0, 0, std::nullopt});
    }
    summary.planned_scenes =
        static_cast<std::int64_t>(setup.timeline.stamps.size() * setup.cameras.size());
    // A shutter may open before the recording begins: objects are where they are first seen then.
    const Stamp first = setup.timeline.stamps.front();
    (void)object_motion.objectPoses(first);
    motion_start = first + picture_taker.offsets().front();
    const Duration settle = fromSeconds(setup.config.physics.settle);
    if (settle.count() > 0) moveWorld(motion_start - std::min(settle, motion_start - Stamp(1)));
    tellPlan();
  }

  void tellPlan() {
    std::string defaults;
    for (const std::string& taken : setup.defaults_taken) {
      defaults += (defaults.empty() ? "" : ", ") + taken;
    }
    if (!defaults.empty()) reporter.info("defaults taken: " + defaults);
    for (const std::string& remark : setup.remarks) reporter.info(remark);
    for (const std::string& note : setup.notes) warnings.add(note);
    countLeftOut("scene left out: TF would be interpolated across more than max_tf_gap",
                 setup.timeline.left_out_gap);
    countLeftOut("scene left out: a transform is not known at its time",
                 setup.timeline.left_out_unknown);
    reporter.info(std::to_string(summary.planned_scenes) + " scenes" + ofCameras() + " from " +
                  fixed(toSeconds(setup.timeline.stamps.front()), 3) + " s on, every " +
                  fixed(1.0 / setup.config.motion.rate, 4) + " s" + ofSplits());
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

  void countLeftOut(const std::string& kind, std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i) warnings.add(kind);
  }

  void moveWorld(Stamp stamp) {
    setup.world->advanceTo(
        // While things settle, the objects stand where they start.
        stamp, [this](int object, Stamp time) {
          return object_motion.at(object, std::max(time, motion_start));
        });
    for (const std::string& gap : object_motion.takeGaps()) warnings.add(gap);
  }

  void warnOfInterpenetrations(Stamp stamp) {
    for (const world::Interpenetration& pair : setup.world->interpenetrations()) {
      warnings.add("'" + pair.first + "' and '" + pair.second + "' are inside one another",
                   "by " + fixed(pair.depth, 3) + " m at " + fixed(toSeconds(stamp), 3) + " s");
    }
  }

  void count(const Scene& scene, const std::vector<std::string>& writer_warnings) {
    for (const std::string& warning : writer_warnings) warnings.add(warning);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      const SceneObject& object = scene.objects[i];
      if (object.in_view) ++summary.objects[i].scenes_in_view;
      if (object.pixels.visible > 0) ++summary.objects[i].scenes_seen;
      if (object.in_view && object.dropped) ++summary.objects[i].scenes_dropped;
    }
    reporter.progress(++summary.scenes, summary.planned_scenes);
  }

  void makeScenes() {
    reporter.progress(0, summary.planned_scenes);
    std::int64_t instant = 0;
    for (const Stamp stamp : setup.timeline.stamps) {
      if (reporter.stopRequested()) {
        summary.stopped = true;
        return;
      }
      makeInstant(instant++, stamp);
    }
    write(std::nullopt);
  }

  /// The scenes of one time: one a camera.
  void makeInstant(std::int64_t instant, Stamp stamp) {
    std::vector<MadeScene> scenes;
    for (const Duration offset : picture_taker.offsets()) {
      moveWorld(stamp + offset);
      picture_taker.expose(stamp, offset);
      if (offset != Duration{0}) continue;
      write(stamp);
      warnOfInterpenetrations(stamp);
      const std::vector<Pose> X_GO = object_motion.objectPoses(stamp);
      for (std::size_t camera = 0; camera < setup.cameras.size(); ++camera) {
        scenes.push_back(scene_maker.make(camera, instant, stamp, X_GO));
      }
    }
    for (MadeScene& made : scenes) {
      made.scene.image = picture_taker.develop(made.scene.camera_index, made.scene.index);
    }
    unwritten = std::move(scenes);
    if (!scene_maker.needsOpticalFlow()) write(std::nullopt);
  }

  /// Writes the scenes that were made last.
  /// @param now  where the world stands, for where their pixels have gone; nothing after the last
  void write(std::optional<Stamp> now) {
    for (MadeScene& made : unwritten) {
      if (scene_maker.needsOpticalFlow()) scene_maker.addOpticalFlow(made, now);
      const Scene& scene = made.scene;
      const auto written = setup.writers->writeScene(scene);
      store->commitScene(scene.index, scene.stamp, written.files);
      count(scene, written.warnings);
    }
    unwritten.clear();
  }

  Reporter& reporter;
  WarningCounter warnings;
  RunSetup setup;
  render::Renderer renderer;
  SceneMaker scene_maker;
  PictureTaker picture_taker;
  ObjectMotion object_motion;
  Stamp motion_start{0};             ///< when the first shutter opens
  std::vector<MadeScene> unwritten;  ///< the last time's, while they wait for the next one
  std::unique_ptr<output::DatasetStore> store;  // last: what fails before leaves the disk alone
  RunSummary summary;
};

Generator::Generator(const Value& parameters, Reporter& reporter,
                     const std::vector<std::string>& plugin_xml_files)
    : impl_(std::make_unique<Impl>(parameters, reporter, plugin_xml_files)) {}

Generator::~Generator() = default;

RunSummary Generator::run() {
  const auto begin = std::chrono::steady_clock::now();
  impl_->makeScenes();
  RunSummary& summary = impl_->summary;
  output::DatasetStore& store = *impl_->store;
  if (!summary.stopped) {
    impl_->setup.writers->finalize(store);
    store.complete();
  }
  summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  summary.files = store.counts().files;
  summary.bytes = store.counts().bytes;
  summary.warnings = impl_->warnings.counts();
  const std::vector<MaskAgreement> agreement = impl_->scene_maker.maskAgreement();
  for (std::size_t i = 0; i < agreement.size(); ++i) {
    if (agreement[i].count == 0) continue;
    summary.objects[i].mask_agreement = agreement[i].sum / static_cast<double>(agreement[i].count);
  }
  summary.manifest = store.manifestPath();
  return summary;
}

}  // namespace synthetic_dataset
