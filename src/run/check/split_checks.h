#pragma once

#include <string>
#include <vector>

#include "run/check/finding.h"
#include "run/setup/expected_labels.h"
#include "run/setup/run_setup.h"

namespace synthetic_dataset::run {

/// About how many labels a split would have.
struct SplitLabels {
  std::string split;
  ClassCounts counts;  ///< of the run's classes
};

/// Of each split of a run, from geometry alone; nothing where there are no splits, or where some
/// scenes are put together at random, whose labels are not known before.
[[nodiscard]] std::vector<SplitLabels> labelsOfSplits(const RunSetup& setup);

/// "labels, as far as boxes reach into the picture: train 153 rover; val 38 rover"
[[nodiscard]] std::string splitLine(const RunSetup& setup, const std::vector<SplitLabels>& splits);

/// Whether a split would have no label, or none of a class that others have.
[[nodiscard]] std::vector<Finding> checkSplits(const RunSetup& setup,
                                               const std::vector<SplitLabels>& splits);

}  // namespace synthetic_dataset::run
