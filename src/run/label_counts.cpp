#include "run/label_counts.h"

#include <algorithm>

namespace synthetic_dataset::run {
namespace {

std::string whyNot(const RunSummary::Object& object) {
  if (object.scenes_in_view == 0) return "it is in view in none of them";
  const std::string in_view = "all " + std::to_string(object.scenes_in_view);
  if (object.scenes_counted > 0 && object.scenes_seen == 0) {
    return "not a pixel of it is seen in " + in_view +
           " in which its box is in view (does something stand before the camera, is the camera "
           "inside of a model, or the object too small?)";
  }
  return "too little of it is seen in " + in_view +
         " in which it is in view (labels/min_pixels, labels/min_visibility)";
}

}  // namespace

std::vector<RunSummary::Object> labelCounts(const output::DatasetStore& store,
                                            const std::vector<scene::ObjectOptions>& objects) {
  std::vector<RunSummary::Object> result;
  const std::vector<output::ObjectCounts> counts = store.objectCounts();
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const output::ObjectCounts& of = counts[i];
    result.push_back({objects[i].name, of.in_view, of.seen, of.dropped, of.counted, of.labelled});
    result.back().is_distractor = objects[i].is_distractor;
    if (of.compared > 0) result.back().mask_agreement = of.mean_mask_agreement;
  }
  return result;
}

std::vector<std::string> missingLabels(const std::vector<RunSummary::Object>& counts,
                                       std::int64_t scenes) {
  const std::string where = "in none of " + std::to_string(scenes) + " scenes";
  if (counts.empty() || scenes == 0) return {};
  std::vector<std::string> messages;
  const auto hasLabel = [](const RunSummary::Object& each) { return each.scenes_labelled > 0; };
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

std::vector<std::string> missingLabels(const output::DatasetStore& store,
                                       const std::vector<scene::ObjectOptions>& objects) {
  return missingLabels(labelCounts(store, objects), store.counts().scenes);
}

void complete(output::DatasetStore& store, const std::vector<scene::ObjectOptions>& objects) {
  std::vector<output::Warning> warnings;
  for (const std::string& message : missingLabels(store, objects)) warnings.push_back({message});
  store.complete(warnings);
}

}  // namespace synthetic_dataset::run
