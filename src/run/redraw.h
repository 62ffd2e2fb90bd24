#pragma once

#include <string>
#include <vector>

#include "output/verify/dataset_verifier.h"

namespace synthetic_dataset::run {

/// Draws a dataset's scenes again, with the settings and inputs listed in its manifest, and has
/// each compared with the dataset's files. Writes nothing; holds one scene at a time.
/// @param listener  is told the progress, and which software has changed its version since
/// @param plugin_xml_files  where to look for writers; if empty, all that installed packages export
/// @throws ErrorList: inputs that are missing or have changed, by name
void redraw(const output::WrittenDataset& dataset, output::SceneVerifier& verifier,
            output::VerificationListener& listener,
            const std::vector<std::string>& plugin_xml_files = {});

}  // namespace synthetic_dataset::run
