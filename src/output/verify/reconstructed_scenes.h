#pragma once

#include <string>
#include <vector>

#include "output/manifest/picture_facts.h"
#include "output/manifest/run_description.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::output {

/// A run as its writers saw it, reconstructed from its manifest.
class ReconstructedScenes {
 public:
  explicit ReconstructedScenes(const RunDescription& run);

  [[nodiscard]] const DatasetInfo& dataset() const { return dataset_; }

  /// What in a scene is unknown to the run, such as a camera: no writer is ever given such a scene.
  /// Empty for a sound one.
  [[nodiscard]] std::string unknownIn(const SceneFacts& facts) const;

  /// A scene without `image`, `depth`, `normals` and `optical_flow`.
  /// @param facts  with a camera model, and nothing unknown
  [[nodiscard]] Scene scene(const SceneFacts& facts) const;

 private:
  DatasetInfo dataset_;
  std::vector<std::string> class_texts_;  ///< one per object
};

}  // namespace synthetic_dataset::output
