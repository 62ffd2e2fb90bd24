#pragma once

#include <memory>
#include <optional>

#include "output/dataset_store.h"
#include "setup/run_setup.h"

namespace synthetic_dataset {

/// The shard that the settings ask for; nothing: the whole run.
[[nodiscard]] std::optional<output::Shard> shardOf(const config::OutputConfig& config);

/// Opens the output, which may remove an earlier dataset or go on with it: the last thing before
/// the first scene.
/// @throws ErrorList with all that stands in the way; the disk is as it was then
[[nodiscard]] std::unique_ptr<output::DatasetStore> openOutput(const RunSetup& setup);

/// The same for a dataset that is made of shards.
[[nodiscard]] std::unique_ptr<output::DatasetStore> openMerged(const RunSetup& setup);

}  // namespace synthetic_dataset
