#include "run/label_counts.h"

#include <algorithm>
#include <utility>

#include "base/name_list.h"

namespace synthetic_dataset::run {
namespace {

constexpr std::size_t kMostNamedObjects = 10;

std::string whyNot(const RunSummary::Object& object) {
  if (object.scenes_in_view == 0) return "never in view";
  const std::string in_view = "the " + std::to_string(object.scenes_in_view) + " scenes";
  if (object.scenes_counted > 0 && object.scenes_seen == 0) {
    return "no pixel is seen in " + in_view +
           " in which the box is in view (does something stand before the camera, is the camera "
           "inside a model, or is the object too small or beyond camera/far?)";
  }
  return "too little is seen in " + in_view + " in view (labels/min_pixels, labels/min_visibility)";
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
                       " does an object have a label (does the camera " +
                       "stand where it should, and are its pose and TF in metres?)");
  }
  std::vector<std::pair<std::string, std::vector<std::string>>> unlabelled;  // by reason
  for (const RunSummary::Object& object : counts) {
    if (hasLabel(object) || object.is_distractor) continue;
    const std::string reason = whyNot(object);
    const auto alike = std::find_if(unlabelled.begin(), unlabelled.end(),
                                    [&](const auto& each) { return each.first == reason; });
    if (alike == unlabelled.end()) {
      unlabelled.push_back({reason, {object.name}});
    } else {
      alike->second.push_back(object.name);
    }
  }
  for (const auto& [reason, names] : unlabelled) {
    messages.push_back((names.size() == 1 ? "object " + names.front() + " has"
                                          : std::to_string(names.size()) + " objects (" +
                                                base::listed(names, kMostNamedObjects) + ") have") +
                       " a label " + where + ": " + reason);
  }
  return messages;
}

std::vector<std::string> unlabelledSplits(const std::vector<output::SplitCounts>& splits) {
  const auto hasLabels = [](const output::SplitCounts& each) { return each.labelled > 0; };
  if (std::none_of(splits.begin(), splits.end(), hasLabels)) return {};  // reported for all
  std::vector<std::string> messages;
  for (const output::SplitCounts& split : splits) {
    if (hasLabels(split)) continue;
    messages.push_back("split " + split.name + " has no label: no object has one in its " +
                       std::to_string(split.scenes) + (split.scenes == 1 ? " scene" : " scenes") +
                       " (other shares of `split`, or another `split/by`, divide the recording "
                       "differently)");
  }
  return messages;
}

std::vector<std::string> missingLabels(const output::DatasetStore& store,
                                       const std::vector<scene::ObjectOptions>& objects) {
  std::vector<std::string> messages =
      missingLabels(labelCounts(store, objects), store.counts().scenes);
  for (std::string& each : unlabelledSplits(store.splitCounts())) {
    messages.push_back(std::move(each));
  }
  return messages;
}

void complete(output::DatasetStore& store, const std::vector<scene::ObjectOptions>& objects) {
  std::vector<base::Warning> warnings;
  for (const std::string& message : missingLabels(store, objects)) warnings.push_back({message});
  store.complete(warnings);
}

}  // namespace synthetic_dataset::run
