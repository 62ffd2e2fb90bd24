#pragma once

#include <optional>
#include <vector>

#include "output/dataset_opening.h"
#include "run/check/finding.h"
#include "run/setup/run_setup.h"

namespace synthetic_dataset::run {

/// The kind of checkEarlierRun's finding.
constexpr const char* kEarlierDataset = "earlier dataset";

/// The dataset that already exists where the run would write; nothing if there is none, or if the
/// run replaces it without asking (`if_exists: overwrite`).
[[nodiscard]] std::optional<output::EarlierRun> earlierRunOf(const RunSetup& setup);

/// Reports whether the run would be refused because of an earlier dataset.
[[nodiscard]] std::optional<Finding> checkEarlierRun(
    const RunSetup& setup, const std::optional<output::EarlierRun>& earlier);

/// Finds foreign files where the run's files go: generate would refuse to run.
[[nodiscard]] std::vector<Finding> checkFilesInTheWay(const RunSetup& setup);

}  // namespace synthetic_dataset::run
