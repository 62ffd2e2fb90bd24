#pragma once

#include <map>
#include <string>
#include <vector>

#include "output/manifest/picture_facts.h"
#include "output/manifest/run_description.h"
#include "output/store_types.h"
#include "plugins/readback/expected_labels.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::output {

/// A run as the formats see it.
class MeasuredScenes {
 public:
  explicit MeasuredScenes(const output::RunDescription& run);

  [[nodiscard]] const std::vector<ClassInfo>& classes() const { return classes_; }

  [[nodiscard]] Value::Map settingsOf(const output::StoreWriter& writer) const;
  [[nodiscard]] Parameters parametersOf(const output::StoreWriter& writer) const;

  /// @param writer  whose warnings are heeded
  [[nodiscard]] formats::MeasuredScene scene(const output::SceneFacts& facts,
                                             const output::StoreWriter& writer) const;

 private:
  std::map<std::string, Value> settings_;  ///< by their full names
  std::vector<ClassInfo> classes_;
  std::vector<formats::MeasuredObject> objects_;  ///< what is the same in all scenes
  bool has_exact_masks_ = true;
};

}  // namespace synthetic_dataset::output
