#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "output/dataset_store.h"
#include "run/run_summary.h"
#include "scene/object_options.h"

namespace synthetic_dataset::run {

/// Counts in how many of a dataset's scenes each object is in view, seen and labelled.
[[nodiscard]] std::vector<RunSummary::Object> labelCounts(
    const output::DatasetStore& store, const std::vector<scene::ObjectOptions>& objects);

/// Messages for the user if one object, or every object, has no label in any scene.
/// @param scenes  number of scenes in the dataset
[[nodiscard]] std::vector<std::string> missingLabels(const std::vector<RunSummary::Object>& counts,
                                                     std::int64_t scenes);

/// Messages for the user if one split of the dataset has no label although others have some.
[[nodiscard]] std::vector<std::string> unlabelledSplits(
    const std::vector<output::SplitCounts>& splits);

/// All of the above messages for a dataset on disk.
[[nodiscard]] std::vector<std::string> missingLabels(
    const output::DatasetStore& store, const std::vector<scene::ObjectOptions>& objects);

/// Completes a dataset; its manifest then lists the missing labels.
void complete(output::DatasetStore& store, const std::vector<scene::ObjectOptions>& objects);

}  // namespace synthetic_dataset::run
