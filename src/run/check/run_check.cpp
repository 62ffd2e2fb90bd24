#include "run/check/run_check.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "output/preflight.h"
#include "output/scene_contents.h"
#include "run/check/camera_checks.h"
#include "run/check/moments.h"
#include "run/check/motion_checks.h"
#include "run/check/named_rays.h"
#include "run/check/output_checks.h"
#include "run/check/scene_statistics.h"
#include "run/check/standing_checks.h"
#include "run/check/variety_checks.h"
#include "run/scene_loop.h"
#include "run/scene_sink.h"
#include "run/setup/run_setup.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::run {
namespace {

/// Keeps some scenes of a run with everything needed to check them; writes nothing.
class CheckSink : public SceneSink {
 public:
  /// @param setup  must outlive this
  /// @param instants  whose scenes are made
  CheckSink(const RunSetup& setup, std::set<std::int64_t> instants);

  /// The requirements of the run's writers, and masks.
  [[nodiscard]] Requirements requirements() const override;
  void begin(const DatasetInfo& /*dataset*/) override {}
  [[nodiscard]] bool wants(std::int64_t scene) const override;

  /// Has the writers turn the scene into files, and counts their bytes.
  [[nodiscard]] std::vector<base::Warning> add(const FinishedScene& finished) override;
  void finish(RunEnd /*end*/) override {}

  [[nodiscard]] const std::vector<FinishedScene>& scenes() const { return scenes_; }
  [[nodiscard]] const SceneStatistics& statistics() const { return statistics_; }

  /// The size of all scenes' files [byte].
  [[nodiscard]] std::int64_t bytes() const { return bytes_; }

  /// How long the writers took for each scene [s].
  [[nodiscard]] const std::vector<double>& writingTimes() const { return writing_times_; }

 private:
  const RunSetup& setup_;
  std::set<std::int64_t> instants_;
  std::vector<FinishedScene> scenes_;
  SceneStatistics statistics_;
  std::int64_t bytes_ = 0;
  std::vector<double> writing_times_;
};

CheckSink::CheckSink(const RunSetup& setup, std::set<std::int64_t> instants)
    : setup_(setup), instants_(std::move(instants)), statistics_(setup.config.labels) {}

Requirements CheckSink::requirements() const {
  Requirements all = setup_.writers->requirements();
  all.silhouettes = all.visible_masks = all.visibility = true;
  return all;
}

bool CheckSink::wants(std::int64_t scene) const {
  return instants_.count(scene / static_cast<std::int64_t>(setup_.config.cameras.size())) != 0;
}

std::vector<base::Warning> CheckSink::add(const FinishedScene& finished) {
  const auto begin = std::chrono::steady_clock::now();
  const output::WriterHost::SceneResult written = setup_.writers->writeScene(finished.scene);
  const output::StoreOptions& options = setup_.config.output;
  for (const output::SceneContent& content :
       output::encodeScene(written.files.files, {options.png_compression, options.jpeg_quality})) {
    // Files with the same pixels are links to a single one.
    bytes_ += static_cast<std::int64_t>(content.bytes().size());
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  writing_times_.push_back(time.count());
  scenes_.push_back(finished);
  statistics_.add(finished.scene);
  std::vector<base::Warning> warnings;
  for (const std::string& warning : written.warnings) warnings.push_back({warning});
  return warnings;
}

/// Passes on reports and measures how long each of a run's instants takes: the loop asks whether to
/// stop before each.
class CheckWatch : public Reporter {
 public:
  explicit CheckWatch(Reporter& user) : user_(user) {}

  void info(const std::string& message) override { user_.info(message); }
  void warning(const std::string& message) override { user_.warning(message); }
  [[nodiscard]] bool stopRequested() const override {
    asked_.push_back(std::chrono::steady_clock::now());
    return user_.stopRequested();
  }

  /// The time from each such query to the next [s].
  [[nodiscard]] std::vector<double> times() const {
    std::vector<double> times;
    for (std::size_t i = 1; i < asked_.size(); ++i) {
      times.push_back(std::chrono::duration<double>(asked_[i] - asked_[i - 1]).count());
    }
    return times;
  }

 private:
  Reporter& user_;
  mutable std::vector<std::chrono::steady_clock::time_point> asked_;
};

/// The instants of about nine scenes, at least four per motion.
std::set<std::int64_t> chosenInstants(const RunSetup& setup) {
  constexpr std::size_t kScenes = 9;
  constexpr std::size_t kLeast = 4;
  const std::size_t wanted = kScenes / (setup.motions.size() * setup.config.cameras.size());
  std::set<std::int64_t> instants;
  for (const MotionSetup& motion : setup.motions) {
    const auto count = static_cast<std::size_t>(motion.instantCount());
    for (const std::size_t i : evenlySpread(count, std::max<std::size_t>(wanted, kLeast))) {
      instants.insert(motion.first_instant + static_cast<std::int64_t>(i));
    }
  }
  return instants;
}

double medianTime(std::vector<double> times) {
  if (times.empty()) return 0.0;
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

/// Estimates the run's duration: drawing and writing run concurrently; the time between scenes is
/// simulated in any case.
double secondsOf(const RunSetup& setup, const CheckSink& sink, std::vector<double> times) {
  const std::size_t made =
      std::min(sink.writingTimes().size() / setup.config.cameras.size(), times.size());
  // The instants at which scenes were made are those that took longest.
  std::sort(times.rbegin(), times.rend());
  const std::vector<double> drawing(times.begin(),
                                    times.begin() + static_cast<std::ptrdiff_t>(made));
  double simulation = 0.0;
  for (std::size_t i = made; i < times.size(); ++i) simulation += times[i];
  const auto cameras = static_cast<double>(setup.config.cameras.size());
  const double an_instant =
      std::max(medianTime(drawing), cameras * medianTime(sink.writingTimes()));
  const auto instants = static_cast<double>(setup.instantCount());
  return simulation + an_instant * instants / std::max(1, setup.config.processes);
}

RunFigures figuresOf(const RunSetup& setup, const CheckSink& sink,
                     const std::vector<double>& times) {
  RunFigures figures;
  const auto made = static_cast<double>(std::max<std::size_t>(sink.scenes().size(), 1));
  figures.bytes = static_cast<std::int64_t>(static_cast<double>(sink.bytes()) / made *
                                            static_cast<double>(setup.description.scene_count));
  figures.free_disk = freeDisk(setup.config.output.folder);
  figures.seconds = secondsOf(setup, sink, times);
  figures.memory = peakMemory() * std::max(1, setup.config.processes);
  figures.memory_limit = memoryLimit();
  return figures;
}

void append(std::vector<Finding>& all, const std::vector<Finding>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

std::vector<const Scene*> scenesOfMotion(const MotionSetup& motion,
                                         const std::vector<FinishedScene>& all) {
  std::vector<const Scene*> scenes;
  for (const FinishedScene& each : all) {
    const std::int64_t index = each.scene.instant - motion.first_instant;
    if (index >= 0 && index < motion.instantCount()) scenes.push_back(&each.scene);
  }
  return scenes;
}

std::vector<Finding> checkScenes(const MotionSetup& motion,
                                 const std::vector<const Scene*>& scenes) {
  const NamedRays rays(*motion.world);
  std::vector<Finding> findings = checkVisibility(motion, rays, scenes);
  append(findings, checkCameras(motion, rays, scenes));
  append(findings, checkLights(motion, rays, scenes));
  append(findings, checkStanding(motion, rays, momentsOf(motion, scenes)));
  return joinAlike(findings);
}

/// Whether a message is about a missing file that `on_missing_asset: warn` accepts.
bool isAboutMissingFile(const base::Diagnostic& each, const RunSetup& setup) {
  const bool may_be =
      std::any_of(setup.motions.begin(), setup.motions.end(), [](const MotionSetup& motion) {
        return motion.config.world.loading.on_missing_asset == world::OnMissingAsset::kWarn;
      });
  return may_be && each.severity == base::Severity::kWarning &&
         each.what.find("no such file") != std::string::npos;
}

/// Combines all missing files in one finding: they were accepted, and only affect what is visible
/// at their places.
std::optional<Finding> missingFiles(const RunSetup& setup) {
  std::vector<std::string> missing;
  for (const base::Diagnostic& each : setup.diagnostics.all()) {
    if (isAboutMissingFile(each, setup)) missing.push_back(each.message());
  }
  if (missing.empty()) return std::nullopt;
  if (missing.size() == 1) return Finding{"missing files", "world", missing.front(), ""};
  return Finding{"missing files", "world",
                 std::to_string(missing.size()) +
                     " files are missing, and whatever needs them is left out (on_missing_asset: "
                     "warn); the first: " +
                     missing.front(),
                 "`inspect` lists all"};
}

/// The findings of set-up, and all its other warnings.
std::vector<Finding> setupFindings(const RunSetup& setup) {
  std::vector<Finding> findings = setup.findings;
  for (const base::Diagnostic& each : setup.diagnostics.all()) {
    if (each.severity != base::Severity::kWarning || isAboutMissingFile(each, setup)) continue;
    const bool is_known =
        std::any_of(setup.findings.begin(), setup.findings.end(),
                    [&](const Finding& finding) { return finding.message() == each.message(); });
    if (!is_known) findings.push_back({"warning", each.where, each.what, ""});
  }
  return findings;
}

/// Checks that a run could write to the folder. Files created for this are removed again.
void requireFolder(const std::string& folder) {
  if (folder.empty()) return;  // each writer has its own
  output::FolderProbe probe;
  probe.tryFolder("output_folder", folder);
  if (!probe.problems().empty()) throw ErrorList(probe.problems());
}

}  // namespace

RunCheck checkRun(const Value& parameters, Reporter& reporter,
                  const std::vector<std::string>& plugin_xml_files) {
  return checkRun(setUpRun(parameters, plugin_xml_files), reporter);
}

RunCheck checkRun(RunSetup setup, Reporter& reporter) {
  RunCheck check{std::move(setup), {}, {}, {}, {}, {}};
  requireFolder(check.setup.config.output.folder);
  CheckSink sink(check.setup, chosenInstants(check.setup));
  CheckWatch stopwatch(reporter);
  SceneLoop(check.setup, sink, stopwatch).run();
  check.scenes = sink.scenes();
  check.figures = figuresOf(check.setup, sink, stopwatch.times());
  check.findings = setupFindings(check.setup);
  for (const MotionSetup& motion : check.setup.motions) {
    std::vector<Finding> findings = checkScenes(motion, scenesOfMotion(motion, check.scenes));
    nameMotion(motion, check.setup.motions.size(), findings);
    append(check.findings, findings);
  }
  append(check.findings, sink.statistics().findings());
  check.splits = labelsOfSplits(check.setup);
  append(check.findings, checkSplits(check.setup, check.splits));
  check.variety = varietyOf(check.setup, check.scenes);
  if (check.variety) append(check.findings, checkVariety(*check.variety));
  append(check.findings, checkFigures(check.figures));
  const auto earlier = checkEarlierRun(check.setup, earlierRunOf(check.setup));
  if (earlier) check.findings.push_back(*earlier);
  append(check.findings, checkFilesInTheWay(check.setup));
  if (const auto missing = missingFiles(check.setup)) check.findings.push_back(*missing);
  return check;
}

}  // namespace synthetic_dataset::run
