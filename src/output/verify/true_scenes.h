#pragma once

#include <string>
#include <vector>

#include "output/manifest/picture_facts.h"
#include "output/manifest/run_description.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::output {

/// A run as its writers saw it, by its manifest.
class TrueScenes {
 public:
  explicit TrueScenes(const RunDescription& run);

  [[nodiscard]] const DatasetInfo& dataset() const { return dataset_; }

  /// What in a scene the run knows nothing of, such as a camera: no writer is ever given such a
  /// scene. Empty for a sound one.
  [[nodiscard]] std::string unknownIn(const SceneFacts& facts) const;

  /// A scene without `image`, `depth`, `normals` and `optical_flow`.
  /// @param facts  with a camera model, and nothing unknown
  [[nodiscard]] Scene scene(const SceneFacts& facts) const;

 private:
  DatasetInfo dataset_;
  std::vector<std::string> class_texts_;  ///< of each object
};

}  // namespace synthetic_dataset::output
