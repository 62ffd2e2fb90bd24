#pragma once

#include "output/manifest/picture_facts.h"
#include "output/manifest/run_description.h"
#include "output/store_types.h"
#include "plugins/readback/found_files.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::output {

/// A run as its writers saw it, by its manifest.
class TrueScenes {
 public:
  explicit TrueScenes(const RunDescription& run);

  [[nodiscard]] const DatasetInfo& dataset() const { return dataset_; }

  /// A scene without its pictures.
  /// @param facts  with a camera model
  /// @param writer  whose warnings are heeded
  [[nodiscard]] formats::TrueScene scene(const SceneFacts& facts, const StoreWriter& writer) const;

 private:
  DatasetInfo dataset_;
  std::vector<std::string> class_texts_;  ///< of each object
  bool has_parts_ = false;                ///< whether an object has named parts
};

}  // namespace synthetic_dataset::output
