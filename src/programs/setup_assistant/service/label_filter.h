#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "output/written_dataset.h"
#include "programs/setup_assistant/web/http_message.h"

namespace synthetic_dataset::programs {

/// A label's size, by visible pixels, in COCO's area classes; empty if these pixels were not
/// counted.
[[nodiscard]] std::string sizeOf(const output::WrittenLabel& label);

/// How much of a label is occluded ("none", "part", "most"); empty if that was not measured.
[[nodiscard]] std::string occlusionOf(const output::WrittenLabel& label);

/// Chooses scenes of a dataset by their split, and by the labels in them.
class LabelFilter {
 public:
  /// @param request  class, split, size, occlusion: one that is missing or empty matches anything
  explicit LabelFilter(const HttpRequest& request);

  /// Whether it selects labels, so that scenes without a matching one are left out.
  [[nodiscard]] bool isOfLabels() const;

  [[nodiscard]] bool takesSplit(const std::string& split) const;
  [[nodiscard]] bool takes(const output::WrittenLabel& label) const;

 private:
  std::string class_;
  std::string split_;
  std::string size_;
  std::string occlusion_;
};

/// The scenes that a filter accepts, and what is in them.
struct ChosenScenes {
  std::vector<std::int64_t> scenes;                ///< their indices, in order
  std::map<std::string, std::int64_t> splits;      ///< number of scenes in each
  std::map<std::string, std::int64_t> classes;     ///< number of accepted labels of each
  std::map<std::string, std::int64_t> sizes;       ///< the same by sizeOf()
  std::map<std::string, std::int64_t> occlusions;  ///< the same by occlusionOf()
};

[[nodiscard]] ChosenScenes chosenScenes(const output::WrittenDataset& dataset,
                                        const LabelFilter& filter);

}  // namespace synthetic_dataset::programs
