#include "run/label_counts.h"

#include <algorithm>

namespace synthetic_dataset::run {
namespace {

bool hasLabel(const RunSummary::Object& object) {
  return object.scenes_in_view > object.scenes_dropped;
}

std::string whyNot(const RunSummary::Object& object) {
  if (object.scenes_in_view == 0) return "it is in view in none of them";
  return "too little of it is seen in all " + std::to_string(object.scenes_in_view) +
         " in which it is in view (labels/min_pixels, labels/min_visibility)";
}

}  // namespace

std::vector<RunSummary::Object> labelCounts(const output::DatasetStore& store,
                                            const std::vector<scene::ObjectOptions>& objects) {
  std::vector<RunSummary::Object> result;
  const std::vector<output::ObjectCounts> counts = store.objectCounts();
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const output::ObjectCounts& of = counts[i];
    result.push_back(
        {objects[i].name, of.in_view, of.seen, of.dropped, std::nullopt, objects[i].is_distractor});
    if (of.compared > 0) result.back().mask_agreement = of.mean_mask_agreement;
  }
  return result;
}

std::vector<std::string> missingLabels(const std::vector<RunSummary::Object>& counts,
                                       std::int64_t scenes) {
  const std::string where = "in none of " + std::to_string(scenes) + " scenes";
  if (counts.empty() || scenes == 0) return {};
  std::vector<std::string> messages;
  if (std::none_of(counts.begin(), counts.end(), hasLabel)) {
    messages.push_back("NOTHING is labelled: " + where +
                       " has an object a label (does the camera " +
                       "stand where it should, and are its pose and TF in metres?)");
  }
  for (const RunSummary::Object& object : counts) {
    if (hasLabel(object) || object.is_distractor) continue;
    messages.push_back("object " + object.name + " has a label " + where + ": " + whyNot(object));
  }
  return messages;
}

}  // namespace synthetic_dataset::run
