#include "run/scene_pipeline.h"

#include <memory>
#include <utility>

namespace synthetic_dataset::run {
namespace {

/// How many scenes may wait while one is being finished, and likewise while one is being added.
constexpr std::size_t kMostWaiting = 1;

/// The drawing data of a scene takes about 40 bytes per pixel.
constexpr std::int64_t kLargeImage = 4'000'000;  // [px]

}  // namespace

ScenePipeline::ScenePipeline(SceneSink& sink, Reporter& reporter, std::int64_t scene_count)
    : sink_(sink),
      reporter_(reporter),
      scene_count_(scene_count),
      adder_(kMostWaiting),
      finisher_(kMostWaiting) {
  reporter_.progress(0, scene_count_);
}

void ScenePipeline::add(PendingScene scene, std::int64_t pixel_count) {
  const StageWatch watch;
  try {
    finisher_.add([this, scene = std::move(scene)] {
      adder_.add([this, finished = std::make_shared<const FinishedScene>(finishScene(scene))] {
        addToSink(*finished);
      });
    });
    if (pixel_count >= kLargeImage) finisher_.finish();
  } catch (...) {
    adder_.finish();  // adds the previous scenes, or throws if one of them failed first
    throw;
  }
  waited_ += watch.seconds();
  report();
}

void ScenePipeline::finish() {
  const StageWatch watch;
  try {
    finisher_.finish();
  } catch (...) {
    adder_.finish();
    throw;
  }
  adder_.finish();
  waited_ += watch.seconds();
  report();
}

FinishedScene ScenePipeline::finishScene(const PendingScene& scene) {
  const StageWatch watch;
  FinishedScene finished = scene();
  const std::lock_guard<std::mutex> lock(mutex_);
  times_.labels += watch.seconds();
  return finished;
}

void ScenePipeline::addToSink(const FinishedScene& finished) {
  const StageWatch watch;
  std::vector<base::Warning> warnings = finished.facts.warnings;
  const std::vector<base::Warning> of_sink = sink_.add(finished);
  warnings.insert(warnings.end(), of_sink.begin(), of_sink.end());
  const std::lock_guard<std::mutex> lock(mutex_);
  unreported_.push_back(std::move(warnings));
  times_.writing += watch.seconds();
}

void ScenePipeline::report() {
  std::vector<std::vector<base::Warning>> added;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    added.swap(unreported_);
  }
  for (const std::vector<base::Warning>& warnings : added) {
    reporter_.warnOfEachKind(warnings);
    reporter_.progress(++added_count_, scene_count_);
  }
}

}  // namespace synthetic_dataset::run
