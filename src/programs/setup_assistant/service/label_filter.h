#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "output/written_dataset.h"
#include "programs/setup_assistant/web/http_message.h"

namespace synthetic_dataset::programs {

/// How large a label is: COCO's classes of areas, by visible pixels; empty where these were not
/// counted.
[[nodiscard]] std::string sizeOf(const output::WrittenLabel& label);

/// How much of a label something hides; empty where that was not measured.
[[nodiscard]] std::string occlusionOf(const output::WrittenLabel& label);

/// Chooses scenes of a dataset by their split, and by the labels in them.
class LabelFilter {
 public:
  /// @param request  class, split, size, occlusion: what is not given, or empty, may be any
  explicit LabelFilter(const HttpRequest& request);

  /// Whether labels are chosen, so that scenes without any are left out.
  [[nodiscard]] bool isOfLabels() const;

  [[nodiscard]] bool takesSplit(const std::string& split) const;
  [[nodiscard]] bool takes(const output::WrittenLabel& label) const;

 private:
  std::string class_;
  std::string split_;
  std::string size_;
  std::string occlusion_;
};

/// The scenes that a filter takes, and what is in them.
struct ChosenScenes {
  std::vector<std::int64_t> scenes;                ///< their indices, in order
  std::map<std::string, std::int64_t> splits;      ///< scenes of each
  std::map<std::string, std::int64_t> classes;     ///< labels of each, of those it takes
  std::map<std::string, std::int64_t> sizes;       ///< the same by sizeOf()
  std::map<std::string, std::int64_t> occlusions;  ///< the same by occlusionOf()
};

[[nodiscard]] ChosenScenes chosenScenes(const output::WrittenDataset& dataset,
                                        const LabelFilter& filter);

}  // namespace synthetic_dataset::programs
