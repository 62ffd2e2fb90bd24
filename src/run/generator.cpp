#include "run/generator.h"

#include <cstdint>
#include <memory>
#include <string>

#include "base/diagnostics.h"
#include "run/dataset_sink.h"
#include "run/label_counts.h"
#include "run/reporter.h"
#include "run/scene_loop.h"
#include "run/setup/run_setup.h"
#include "run/stage_times.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::run {
namespace {

/// The motion's first time [s].
std::string startOf(const MotionSetup& motion) {
  return fixed(toSeconds(motion.timeline.stamps.front()), 3);
}

std::string whenMade(const MotionSetup& motion) {
  if (!motion.timeline.is_recorded) return ", placed";
  if (motion.pictures) {
    return " at the times of recorded pictures from " + startOf(motion) + " s on, one every " +
           fixed(1.0 / motion.config.motion.rate, 4) + " s (median)";
  }
  return " from " + startOf(motion) + " s on, every " + fixed(1.0 / motion.config.motion.rate, 4) +
         " s" + (motion.timeline.jitter.empty() ? "" : " except for randomize/time/jitter");
}

std::string rangeOf(const MotionSetup& motion) {
  const std::int64_t last = motion.first_instant + motion.instantCount() - 1;
  return "motion '" + motion.entry.name + "': numbers " + std::to_string(motion.first_instant) +
         " to " + std::to_string(last) +
         (motion.timeline.is_recorded ? ", recorded from " + startOf(motion) + " s on"
                                      : ", placed");
}

std::string scenesOf(const RunSetup& setup) {
  const std::size_t cameras = setup.config.cameras.size();
  return std::to_string(setup.description.scene_count) + " scenes" +
         (cameras == 1 ? "" : " of " + std::to_string(cameras) + " cameras");
}

std::string splitsOf(const RunSetup& setup) {
  std::string text;
  for (const SplitInfo& split : setup.splits->splits(setup.config.cameras.size())) {
    text += (text.empty() ? "; " : ", ") + split.name + " " + std::to_string(split.scene_count);
  }
  return text;
}

/// Describes which part of the run's scenes this process makes.
std::string partOf(const RunSetup& setup, const DatasetSink& dataset) {
  const config::Config& config = setup.config;
  const std::string makes = " makes " + std::to_string(dataset.plannedCount());
  std::string text;
  if (config.output.shard) {
    text += "; shard " + std::to_string(config.output.shard->index) + " of 0 to " +
            std::to_string(config.output.shard->count - 1) + makes;
  }
  if (!config.only_scenes.empty()) {
    text += "; only_scenes" + makes + ", and leaves the dataset open for the others";
  }
  return text;
}

void reportMotions(const RunSetup& setup, const DatasetSink& dataset, Reporter& reporter) {
  const std::size_t count = setup.motions.size();
  const std::string when =
      count == 1 ? whenMade(setup.motions.front()) : " of " + std::to_string(count) + " motions";
  reporter.info(scenesOf(setup) + when + splitsOf(setup) + partOf(setup, dataset));
  if (count == 1) return;
  for (const MotionSetup& motion : setup.motions) reporter.info(rangeOf(motion));
}

/// Reports what a run will make, before its first scene.
/// @param dataset  must have begun
/// @param missing_count  how many of its scenes are still to be made
void reportPlan(const RunSetup& setup, const DatasetSink& dataset, std::int64_t missing_count,
                Reporter& reporter) {
  std::string defaults;
  for (const std::string& taken : setup.defaults_taken) {
    defaults += (defaults.empty() ? "" : ", ") + taken;
  }
  if (!defaults.empty()) reporter.info("defaults taken: " + defaults);
  for (const std::string& note : setup.diagnostics.messages(base::Severity::kNote))
    reporter.info(note);
  reporter.warnOfEachKind(setup.description.warnings);
  reportMotions(setup, dataset, reporter);
  const std::int64_t there = dataset.plannedCount() - missing_count;
  if (dataset.store().wasComplete()) {
    reporter.info(std::string(setup.config.output.shard ? "the shard" : "the dataset") +
                  " is complete already: there is nothing to do");
  } else if (there > 0) {
    reporter.info("resuming: " + std::to_string(there) + " of these scenes exist already");
  }
}

}  // namespace

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

  /// Adds the totals of the whole dataset at the end of the run.
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

  StageWatch watch;  ///< first, since it times the construction of the others
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
