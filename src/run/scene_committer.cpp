#include "run/scene_committer.h"

#include <memory>
#include <utility>

namespace synthetic_dataset {
namespace {

/// How many scenes may wait while one is finished, and as many while one is written.
constexpr std::size_t kMostWaiting = 1;

}  // namespace

SceneCommitter::SceneCommitter(const writers::WriterHost& writers, output::DatasetStore& store)
    : writers_(writers), store_(store), writer_(kMostWaiting), finisher_(kMostWaiting) {}

void SceneCommitter::add(PendingScene scene) {
  try {
    finisher_.add([this, scene = std::move(scene)] {
      writer_.add(
          [this, finished = std::make_shared<FinishedScene>(scene())] { commit(*finished); });
    });
  } catch (...) {
    writer_.finish();  // the scenes before are written, or one of them has failed first
    throw;
  }
}

void SceneCommitter::finish() {
  try {
    finisher_.finish();
  } catch (...) {
    writer_.finish();
    throw;
  }
  writer_.finish();
}

std::vector<std::vector<output::Warning>> SceneCommitter::takeCommitted() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(committed_, {});
}

void SceneCommitter::commit(FinishedScene& finished) {
  output::SceneFacts& facts = finished.facts;
  const writers::WriterHost::SceneResult written = writers_.writeScene(finished.scene);
  for (const std::string& warning : written.warnings) facts.warnings.push_back({warning});
  store_.commitScene(facts, written.files);
  const std::lock_guard<std::mutex> lock(mutex_);
  committed_.push_back(std::move(facts.warnings));
}

}  // namespace synthetic_dataset
