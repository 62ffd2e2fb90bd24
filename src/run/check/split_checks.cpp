#include "run/check/split_checks.h"

#include <algorithm>
#include <cstddef>

#include "base/name_list.h"

namespace synthetic_dataset::run {
namespace {

bool isKnown(const MotionSetup& motion) {
  return motion.timeline.is_recorded &&
         std::none_of(motion.cameras.begin(), motion.cameras.end(),
                      [](const scene::CameraRig& camera) { return camera.sampled; });
}

std::string cureOf(const config::SplitConfig& split) {
  if (split.by == config::SplitBy::kBalancedBlocks) {
    return "other shares, or a part of the recording in which it is seen more often, would help";
  }
  return "`split/by: balanced_blocks` chooses stretches of the recording so that each split has "
         "each class, if possible";
}

}  // namespace

std::vector<SplitLabels> labelsOfSplits(const RunSetup& setup) {
  if (!std::all_of(setup.motions.begin(), setup.motions.end(), isKnown)) return {};
  std::vector<SplitLabels> splits;
  for (const SplitInfo& split : setup.splits->splits(1)) {
    splits.push_back({split.name, ClassCounts(setup.config.classes.size(), 0)});
  }
  if (splits.empty()) return {};
  for (const MotionSetup& motion : setup.motions) {
    std::int64_t instant = motion.first_instant;
    for (const ClassCounts& counts : expectedLabels(motion)) {
      const std::string& name = setup.splits->at(instant++);
      for (SplitLabels& split : splits) {
        if (split.split != name) continue;
        for (std::size_t i = 0; i < counts.size(); ++i) split.counts[i] += counts[i];
      }
    }
  }
  return splits;
}

std::string splitLine(const RunSetup& setup, const std::vector<SplitLabels>& splits) {
  std::string line;
  for (const SplitLabels& split : splits) {
    std::vector<std::string> counts;
    for (std::size_t i = 0; i < split.counts.size(); ++i) {
      counts.push_back(std::to_string(split.counts[i]) + " " + setup.config.classes[i].name);
    }
    line += (line.empty() ? "" : "; ") + split.split + " " + base::listed(counts, 8);
  }
  return "labels, counting boxes that reach into the picture: " + line;
}

std::vector<Finding> checkSplits(const RunSetup& setup, const std::vector<SplitLabels>& splits) {
  std::vector<Finding> findings;
  ClassCounts all(setup.config.classes.size(), 0);
  for (const SplitLabels& split : splits) {
    for (std::size_t i = 0; i < all.size(); ++i) all[i] += split.counts[i];
  }
  for (const SplitLabels& split : splits) {
    std::vector<std::string> missing;
    std::size_t there = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      there += all[i] > 0 ? 1 : 0;
      if (all[i] > 0 && split.counts[i] == 0) missing.push_back(setup.config.classes[i].name);
    }
    if (missing.empty()) continue;
    const std::string what =
        missing.size() == there ? "no label at all" : "no label of " + base::listed(missing, 8);
    findings.push_back({"split without labels", "split",
                        split.split + " would have " + what +
                            ": no such object reaches into the picture at any of its times",
                        cureOf(setup.config.split)});
  }
  return findings;
}

}  // namespace synthetic_dataset::run
