#include "run/scene_committer.h"

#include <memory>
#include <utility>

namespace synthetic_dataset {
namespace {

/// How many scenes may wait while one is written.
constexpr std::size_t kMostWaiting = 2;

}  // namespace

SceneCommitter::SceneCommitter(const writers::WriterHost& writers, output::DatasetStore& store)
    : writers_(writers), store_(store), worker_(kMostWaiting) {}

void SceneCommitter::add(Scene scene, render::PendingPicture image, output::SceneFacts facts) {
  worker_.add([this, scene = std::make_shared<Scene>(std::move(scene)), image = std::move(image),
               facts = std::move(facts)]() mutable {
    scene->image = std::exchange(image, {})();  // what it was made of is not needed any more
    commit(*scene, facts);
  });
}

std::vector<std::vector<output::Warning>> SceneCommitter::takeCommitted() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(committed_, {});
}

void SceneCommitter::commit(const Scene& scene, output::SceneFacts& facts) {
  const writers::WriterHost::SceneResult written = writers_.writeScene(scene);
  for (const std::string& warning : written.warnings) facts.warnings.push_back({warning});
  store_.commitScene(facts, written.files);
  const std::lock_guard<std::mutex> lock(mutex_);
  committed_.push_back(std::move(facts.warnings));
}

}  // namespace synthetic_dataset
