#pragma once

#include <optional>
#include <vector>

#include "output/dataset_opening.h"
#include "run/check/finding.h"
#include "run/setup/run_setup.h"

namespace synthetic_dataset::run {

/// The kind of what checkEarlierRun finds.
constexpr const char* kEarlierDataset = "earlier dataset";

/// The dataset that lies where the run is to write; nothing where there is none, or where the run
/// replaces it without asking (`if_exists: overwrite`).
[[nodiscard]] std::optional<output::EarlierRun> earlierRunOf(const RunSetup& setup);

/// Says so if the run would be refused because of an earlier dataset.
[[nodiscard]] std::optional<Finding> checkEarlierRun(
    const RunSetup& setup, const std::optional<output::EarlierRun>& earlier);

/// Files of others where the run's files go: generate would refuse them.
[[nodiscard]] std::vector<Finding> checkFilesInTheWay(const RunSetup& setup);

}  // namespace synthetic_dataset::run
