#pragma once

#include <memory>
#include <string>
#include <vector>

#include "output/dataset_store.h"
#include "run/setup/run_setup.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// Opens the output, which may remove an earlier dataset or go on with it: the last thing before
/// the first scene.
/// @throws ErrorList with all that prevents it; the disk is as it was then
[[nodiscard]] std::unique_ptr<output::DatasetStore> openOutput(const RunSetup& setup);

/// Removes an earlier dataset that a run with these settings would overwrite, and leaves none.
/// @throws ErrorList with all that is wrong with the settings or prevents it
void clearOutput(const Value& parameters, const std::vector<std::string>& plugin_xml_files = {});

/// The same for a dataset that is made of shards.
[[nodiscard]] std::unique_ptr<output::DatasetStore> openMerged(const RunSetup& setup);

}  // namespace synthetic_dataset::run
