#include "run/generator.h"

#include <chrono>
#include <memory>
#include <utility>

#include "run/label_counts.h"
#include "run/motion_run.h"
#include "run/open_output.h"
#include "run/scene_committer.h"
#include "run/warning_teller.h"
#include "run/work_plan.h"
#include "scene/seconds.h"
#include "setup/run_setup.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {

struct Generator::Impl {
  Impl(const Value& parameters, Reporter& user, const std::vector<std::string>& plugin_xml_files)
      : reporter(user),
        warnings(user),
        setup(setUpRun(parameters, plugin_xml_files)),
        run(makeRun(setup.motions.front())),
        store(openStore()),
        work(setup.instantCount(), cameraCount(), shardOf(setup.config.output),
             setup.config.output.only_scenes, [this](std::int64_t scene) {
               return store->wasComplete() || store->hasScene(scene);
             }) {
    tellPlan();
  }

  [[nodiscard]] std::unique_ptr<MotionRun> makeRun(MotionSetup& motion) {
    return std::make_unique<MotionRun>(setup, motion, [this](PendingScene scene) {
      committer.add(std::move(scene));
      tellWritten();
    });
  }

  /// With all that its manifest is to tell; nothing is written where drawing is not possible.
  [[nodiscard]] std::unique_ptr<output::DatasetStore> openStore() {
    setup.description.software["opengl"] = run->glVersion();
    return openOutput(setup);
  }

  [[nodiscard]] std::int64_t cameraCount() const {
    return static_cast<std::int64_t>(setup.config.cameras.size());
  }

  void tellPlan() {
    std::string defaults;
    for (const std::string& taken : setup.defaults_taken) {
      defaults += (defaults.empty() ? "" : ", ") + taken;
    }
    if (!defaults.empty()) reporter.info("defaults taken: " + defaults);
    for (const std::string& note : setup.found.messages(base::Severity::kNote)) reporter.info(note);
    warnings.tell(setup.description.warnings);
    tellMotions();
    if (store->wasComplete()) {
      reporter.info(std::string(setup.config.output.shard ? "the shard" : "the dataset") +
                    " is complete already: there is nothing to do");
    } else if (work.missingCount() < work.sceneCount()) {
      reporter.info("going on: " + std::to_string(work.sceneCount() - work.missingCount()) +
                    " of these scenes are there already");
    }
  }

  [[nodiscard]] static std::string whenMade(const MotionSetup& motion) {
    if (!motion.timeline.is_recorded) return ", placed";
    return " from " + startOf(motion) + " s on, every " +
           fixed(1.0 / motion.config.motion.rate, 4) + " s" +
           (motion.timeline.jitter.empty() ? "" : " but for randomize/time/jitter");
  }

  void tellMotions() {
    const std::string all = std::to_string(setup.description.scene_count) + " scenes" + ofCameras();
    const std::string rest = ofSplits() + ofShard() + ofChoice();
    if (setup.motions.size() == 1) {
      const MotionSetup& motion = setup.motions.front();
      reporter.info(all + whenMade(motion) + rest);
      return;
    }
    reporter.info(all + " of " + std::to_string(setup.motions.size()) + " motions" + rest);
    for (const MotionSetup& motion : setup.motions) {
      const std::int64_t last = motion.first_instant + motion.instantCount() - 1;
      reporter.info("motion '" + motion.entry.name + "': numbers " +
                    std::to_string(motion.first_instant) + " to " + std::to_string(last) +
                    (motion.timeline.is_recorded ? ", recorded from " + startOf(motion) + " s on"
                                                 : ", placed"));
    }
  }

  /// Its first time [s].
  [[nodiscard]] static std::string startOf(const MotionSetup& motion) {
    return fixed(toSeconds(motion.timeline.stamps.front()), 3);
  }

  [[nodiscard]] std::string ofSplits() const {
    std::string text;
    for (const SplitInfo& split : setup.splits->splits(setup.config.cameras.size())) {
      text += (text.empty() ? "; " : ", ") + split.name + " " + std::to_string(split.scene_count);
    }
    return text;
  }

  [[nodiscard]] std::string ofCameras() const {
    if (cameraCount() == 1) return "";
    return " of " + std::to_string(cameraCount()) + " cameras";
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

  void makeScenes() {
    reporter.progress(0, work.missingCount());
    for (MotionSetup& motion : setup.motions) {
      const std::int64_t end = motion.first_instant + motion.instantCount();
      if (work.endOfWork(end) <= motion.first_instant) continue;
      if (!run->isOf(motion)) {
        run.reset();  // two cannot draw at once
        run = makeRun(motion);
      }
      summary.stopped = !run->run(work, [this] { return reporter.stopRequested(); });
      committer.finish();  // pictures are made with what the run draws
      if (summary.stopped) break;
    }
    tellWritten();
    // The files of the dataset as a whole may take long, too.
    summary.stopped = summary.stopped || reporter.stopRequested();
  }

  /// The reporter hears of scenes in the thread that runs.
  void tellWritten() {
    for (const std::vector<output::Warning>& of_scene : committer.takeCommitted()) {
      warnings.tell(of_scene);
      reporter.progress(++summary.scenes, work.missingCount());
    }
  }

  /// Whether all scenes of the dataset are there, and not those of a shard or a choice alone.
  [[nodiscard]] bool isWhole() const {
    const config::OutputConfig& output = setup.config.output;
    return !summary.stopped && !output.shard && output.only_scenes.empty();
  }

  /// What the whole dataset holds, for the run's last words.
  void summarize() {
    summary.dataset_scenes = store->counts().scenes;
    summary.planned_scenes = work.sceneCount();
    summary.files = store->counts().files;
    summary.bytes = store->counts().bytes;
    summary.warnings = store->warningCounts();
    summary.objects = labelCounts(*store, setup.config.objects);
    if (!isWhole()) return;
    for (const std::string& message : missingLabels(summary.objects, summary.dataset_scenes)) {
      reporter.warning(message);
    }
  }

  Reporter& reporter;
  WarningTeller warnings;
  RunSetup setup;
  std::unique_ptr<MotionRun> run;  ///< of the motion whose scenes are made now, or come first
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
