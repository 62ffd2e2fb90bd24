#include "generator.h"

#include <chrono>
#include <utility>

#include "render/renderer.h"
#include "run_setup.h"
#include "scene_maker.h"
#include "synthetic_dataset/label_text.h"
#include "warning_counter.h"

namespace synthetic_dataset {
namespace {

render::RenderOptions renderOptions(const config::RenderingConfig& config) {
  return {config.samples, config.shadow_map_size, config.shadow_distance};
}

MaskOptions maskOptions(const config::MaskConfig& config) {
  return {{config.history_length, config.var_threshold, config.detect_shadows}, config.clean};
}

std::vector<annotate::ObjectShape> objectShapes(const config::Config& config) {
  std::vector<annotate::ObjectShape> shapes;
  for (const config::ObjectConfig& object : config.objects) {
    shapes.push_back(
        {object.name, object.class_name, object.id, object.keypoints_O, object.bounding_shape_O});
  }
  return shapes;
}

/// Where objects are, between scenes too: where the recording says, or, over a gap, where they
/// were.
class ObjectPoses {
 public:
  ObjectPoses(const motion::BagMotion& recording, const config::Config& config)
      : recording_(recording), config_(config), last_(config.objects.size(), Pose::Identity()) {}

  Pose at(int object, Stamp time) {
    const auto i = static_cast<std::size_t>(object);
    const std::string& frame = config_.objects[i].frame;
    if (recording_.canTransform(config_.global_frame, frame, time)) {
      last_[i] = recording_.transform(config_.global_frame, frame, time);
    }
    return last_[i];
  }

  /// Of all objects at a time at which the recording knows them.
  std::vector<Pose> allAt(Stamp time) {
    for (std::size_t i = 0; i < last_.size(); ++i) (void)at(static_cast<int>(i), time);
    return last_;
  }

 private:
  const motion::BagMotion& recording_;
  const config::Config& config_;
  std::vector<Pose> last_;
};

}  // namespace

struct Generator::Impl {
  Impl(const Value& parameters, Reporter& user, const std::vector<std::string>& plugin_xml_files)
      : reporter(user),
        warnings(user),
        setup(setUpRun(parameters, plugin_xml_files)),
        renderer(setup.world->description(), setup.world->links(),
                 renderOptions(setup.config.rendering)),
        scene_maker(*setup.world, renderer, *setup.recording, *setup.camera,
                    setup.config.global_frame, objectShapes(setup.config),
                    setup.writers->requirements(), maskOptions(setup.config.masks)),
        object_poses(*setup.recording, setup.config),
        store(openOutput(setup)) {
    for (const config::ObjectConfig& object : setup.config.objects) {
      summary.objects.push_back({object.name, 0});
    }
    summary.planned_scenes = static_cast<std::int64_t>(setup.timeline.stamps.size());
    tellPlan();
  }

  void tellPlan() {
    std::string defaults;
    for (const std::string& taken : setup.defaults_taken) {
      defaults += (defaults.empty() ? "" : ", ") + taken;
    }
    if (!defaults.empty()) reporter.info("defaults taken: " + defaults);
    for (const std::string& note : setup.notes) warnings.add(note);
    countLeftOut("scene left out: TF would be interpolated across more than max_tf_gap",
                 setup.timeline.left_out_gap);
    countLeftOut("scene left out: a transform is not known at its time",
                 setup.timeline.left_out_unknown);
    reporter.info(std::to_string(summary.planned_scenes) + " scenes from " +
                  fixed(toSeconds(setup.timeline.stamps.front()), 3) + " s on, every " +
                  fixed(1.0 / setup.config.motion.rate, 4) + " s");
  }

  void countLeftOut(const std::string& kind, std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i) warnings.add(kind);
  }

  void moveWorld(Stamp stamp) {
    setup.world->advanceTo(
        stamp, [this](int object, Stamp time) { return object_poses.at(object, time); });
    for (const world::Interpenetration& pair : setup.world->interpenetrations()) {
      warnings.add("'" + pair.first + "' and '" + pair.second + "' are inside one another",
                   "by " + fixed(pair.depth, 3) + " m at " + fixed(toSeconds(stamp), 3) + " s");
    }
  }

  void count(const Scene& scene, const std::vector<std::string>& writer_warnings) {
    for (const std::string& warning : writer_warnings) warnings.add(warning);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      if (scene.objects[i].in_view) ++summary.objects[i].scenes_in_view;
    }
    reporter.progress(++summary.scenes, summary.planned_scenes);
  }

  void makeScenes() {
    reporter.progress(0, summary.planned_scenes);
    for (const Stamp stamp : setup.timeline.stamps) {
      if (reporter.stopRequested()) {
        summary.stopped = true;
        return;
      }
      const std::int64_t index = summary.scenes;
      moveWorld(stamp);
      const Scene scene = scene_maker.make(index, stamp, object_poses.allAt(stamp));
      const auto written = setup.writers->writeScene(scene);
      store->commitScene(index, stamp, written.files);
      count(scene, written.warnings);
    }
  }

  Reporter& reporter;
  WarningCounter warnings;
  RunSetup setup;
  render::Renderer renderer;
  SceneMaker scene_maker;
  ObjectPoses object_poses;
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
  summary.manifest = store.manifestPath();
  return summary;
}

}  // namespace synthetic_dataset
