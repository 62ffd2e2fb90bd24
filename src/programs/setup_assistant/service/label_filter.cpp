#include "programs/setup_assistant/service/label_filter.h"

namespace synthetic_dataset::programs {
namespace {

// https://cocodataset.org/#detection-eval
constexpr std::int64_t kSmall = 32 * 32;   // [px]
constexpr std::int64_t kMedium = 96 * 96;  // [px]

constexpr double kSeenWhole = 0.95;  // the rest may be pixels at the edge of what is in front
constexpr double kHalf = 0.5;

bool isWanted(const std::string& wanted, const std::string& found) {
  return wanted.empty() || wanted == found;
}

void count(const std::string& kind, std::map<std::string, std::int64_t>& counts) {
  if (!kind.empty()) ++counts[kind];
}

}  // namespace

std::string sizeOf(const output::WrittenLabel& label) {
  if (!label.visible_pixels) return "";
  if (*label.visible_pixels < kSmall) return "small";
  return *label.visible_pixels < kMedium ? "medium" : "large";
}

std::string occlusionOf(const output::WrittenLabel& label) {
  if (!label.visibility) return "";
  if (*label.visibility >= kSeenWhole) return "none";
  return *label.visibility >= kHalf ? "part" : "most";
}

LabelFilter::LabelFilter(const HttpRequest& request)
    : class_(request.parameter("class").value_or("")),
      split_(request.parameter("split").value_or("")),
      size_(request.parameter("size").value_or("")),
      occlusion_(request.parameter("occlusion").value_or("")) {}

bool LabelFilter::isOfLabels() const {
  return !class_.empty() || !size_.empty() || !occlusion_.empty();
}

bool LabelFilter::takesSplit(const std::string& split) const { return isWanted(split_, split); }

bool LabelFilter::takes(const output::WrittenLabel& label) const {
  return isWanted(class_, label.class_name) && isWanted(size_, sizeOf(label)) &&
         isWanted(occlusion_, occlusionOf(label));
}

ChosenScenes chosenScenes(const output::WrittenDataset& dataset, const LabelFilter& filter) {
  ChosenScenes chosen;
  const std::map<std::int64_t, std::string> splits = dataset.splitsOfScenes();
  const auto add = [&](std::int64_t scene, const std::string& split) {
    if (!chosen.scenes.empty() && chosen.scenes.back() == scene) return;
    chosen.scenes.push_back(scene);
    count(split, chosen.splits);
  };
  if (!filter.isOfLabels()) {
    for (const auto& [scene, split] : splits) {
      if (filter.takesSplit(split)) add(scene, split);
    }
  }
  dataset.forEachLabel([&](const output::WrittenLabel& label) {
    const auto split = splits.find(label.scene);
    if (split == splits.end()) return;  // a run has added the scene meanwhile
    if (!filter.takesSplit(split->second) || !filter.takes(label)) return;
    if (filter.isOfLabels()) add(label.scene, split->second);
    count(label.class_name, chosen.classes);
    count(sizeOf(label), chosen.sizes);
    count(occlusionOf(label), chosen.occlusions);
  });
  return chosen;
}

}  // namespace synthetic_dataset::programs
