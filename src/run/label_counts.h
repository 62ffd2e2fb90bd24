#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "output/dataset_store.h"
#include "run/run_summary.h"
#include "scene/object_options.h"

namespace synthetic_dataset::run {

/// In how many of a dataset's scenes each object is in view, seen and labelled.
[[nodiscard]] std::vector<RunSummary::Object> labelCounts(
    const output::DatasetStore& store, const std::vector<scene::ObjectOptions>& objects);

/// What the user should know where an object, or all of them, has no label in any scene.
/// @param scenes  of the dataset
[[nodiscard]] std::vector<std::string> missingLabels(const std::vector<RunSummary::Object>& counts,
                                                     std::int64_t scenes);

/// What the user should know where a part of the dataset has no label, though others have.
[[nodiscard]] std::vector<std::string> unlabelledSplits(
    const std::vector<output::SplitCounts>& splits);

/// All of these of what a dataset holds.
[[nodiscard]] std::vector<std::string> missingLabels(
    const output::DatasetStore& store, const std::vector<scene::ObjectOptions>& objects);

/// Completes a dataset; its manifest then lists the labels that are missing.
void complete(output::DatasetStore& store, const std::vector<scene::ObjectOptions>& objects);

}  // namespace synthetic_dataset::run
