/// Compares a scene's files with a new rendering of it.

#include <string>
#include <vector>

#include "output/manifest/manifest_paths.h"
#include "output/verify/label_checks.h"
#include "output/verify/scene_verifier.h"

namespace synthetic_dataset::output {

void SceneVerifier::verifyDrawn(const DrawnScene& drawn) {
  ++counts_.drawn;
  const SceneFacts facts = dataset_.facts(drawn.facts.index);
  for (const std::string& line : poseProblems(facts, drawn.facts, dataset_.content().run)) {
    listener_.problem(std::string(kDrawnAgain) + "scene " + std::to_string(facts.index) + ": " +
                      line);
  }
  std::vector<WrittenFiles> files(labels_.size());
  dataset_.forEachFileOf(facts.index, [&](const ListedFile& file) {
    if (file.writer >= files.size() || !pathProblem(file, dataset_).empty()) return;
    files[file.writer].listed.push_back(file);
    files[file.writer].paths.push_back(absoluteFrom(dataset_.folder(), file.path));
  });
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    if (labels_[i].writer == nullptr) continue;  // the reason has been reported
    try {
      RewrittenScene right{{}, {}, drawn.quality};
      right.result.files.recorded = drawn.recorded;
      labels_[i].writer->writeScene(drawn.scene, i, right.result);
      compare(facts, i, files[i], foundScene(facts, i, files[i]), right);
    } catch (const std::exception& error) {
      report(i, kDrawnAgain + originOf(facts, i) + error.what());
    }
  }
}

}  // namespace synthetic_dataset::output
