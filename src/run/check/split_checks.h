#pragma once

#include <string>
#include <vector>

#include "run/check/finding.h"
#include "run/setup/expected_labels.h"
#include "run/setup/run_setup.h"

namespace synthetic_dataset::run {

/// The approximate number of labels in a split.
struct SplitLabels {
  std::string split;
  ClassCounts counts;  ///< for each of the run's classes
};

/// Estimates the labels of each split of a run, from geometry only; empty if there are no splits,
/// or if some scenes are composed at random, whose labels are not known in advance.
[[nodiscard]] std::vector<SplitLabels> labelsOfSplits(const RunSetup& setup);

/// "labels, as far as boxes reach into the picture: train 153 rover; val 38 rover"
[[nodiscard]] std::string splitLine(const RunSetup& setup, const std::vector<SplitLabels>& splits);

/// Finds splits that would have no label, or none of a class that others have.
[[nodiscard]] std::vector<Finding> checkSplits(const RunSetup& setup,
                                               const std::vector<SplitLabels>& splits);

}  // namespace synthetic_dataset::run
