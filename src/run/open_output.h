#pragma once

#include <memory>
#include <string>
#include <vector>

#include "output/dataset_store.h"
#include "run/setup/run_setup.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {

/// Opens the output, which may remove or continue an earlier dataset: the last step before the
/// first scene.
/// @throws ErrorList with everything that prevents it; the disk is then unchanged
[[nodiscard]] std::unique_ptr<output::DatasetStore> openOutput(const RunSetup& setup);

/// Removes an earlier dataset that a run with these settings would overwrite, without starting a
/// new one.
/// @throws ErrorList with everything that is wrong with the settings or prevents it
void clearOutput(const Value& parameters, const std::vector<std::string>& plugin_xml_files = {});

/// Opens the output for a dataset that is merged from shards.
[[nodiscard]] std::unique_ptr<output::DatasetStore> openMerged(const RunSetup& setup);

}  // namespace synthetic_dataset::run
