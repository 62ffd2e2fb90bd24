#include "run/generator.h"

#include <memory>

#include "run/dataset_sink.h"
#include "run/label_counts.h"
#include "run/plan_report.h"
#include "run/scene_loop.h"
#include "run/setup/run_setup.h"
#include "run/stage_times.h"

namespace synthetic_dataset::run {

struct Generator::Impl {
  Impl(const Value& parameters, Reporter& user, const std::vector<std::string>& plugin_xml_files)
      : reporter(user),
        setup(setUpRun(parameters, plugin_xml_files,
                       [&user](const std::string& stage) { user.stage(stage); })),
        dataset(setup),
        loop(setup, dataset, reporter) {
    reportPlan(setup, dataset, loop.sceneCount(), reporter);
    setup_seconds = watch.seconds();
  }

  /// What the whole dataset holds, for the end of the run.
  void summarizeDataset(RunSummary& summary) const {
    const output::DatasetStore& store = dataset.store();
    summary.dataset_scenes = store.counts().scenes;
    summary.planned_scenes = dataset.plannedCount();
    summary.files = store.counts().files;
    summary.bytes = store.counts().bytes;
    summary.warnings = store.warningCounts();
    for (const Finding& odd : dataset.statistics().findings()) reporter.warning(odd.message());
    summary.objects = labelCounts(store, setup.config.objects);
    const config::Config& config = setup.config;
    if (summary.stopped || config.output.shard || !config.only_scenes.empty()) return;
    summary.missing_labels = missingLabels(store, config.objects);
    for (const std::string& message : summary.missing_labels) reporter.warning(message);
  }

  StageWatch watch;  ///< first: it measures what makes the others
  Reporter& reporter;
  RunSetup setup;
  DatasetSink dataset;
  SceneLoop loop;
  double setup_seconds = 0.0;
};

Generator::Generator(const Value& parameters, Reporter& reporter,
                     const std::vector<std::string>& plugin_xml_files)
    : impl_(std::make_unique<Impl>(parameters, reporter, plugin_xml_files)) {}

Generator::~Generator() = default;

RunSummary Generator::run() {
  RunSummary summary;
  summary.manifest = impl_->dataset.store().manifestPath();
  summary.was_complete = impl_->dataset.store().wasComplete();
  if (summary.was_complete) return summary;
  const StageWatch watch;
  const SceneLoop::Result made = impl_->loop.run();
  summary.seconds = watch.seconds();
  summary.scenes = made.scenes;
  summary.times = made.times;
  summary.times.setup = impl_->setup_seconds;
  summary.stopped = made.end == RunEnd::kStopped;
  impl_->summarizeDataset(summary);
  return summary;
}

}  // namespace synthetic_dataset::run
