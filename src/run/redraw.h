#pragma once

#include <string>
#include <vector>

#include "output/verify/dataset_verifier.h"

namespace synthetic_dataset::run {

/// Draws the scenes that a dataset has again, with the settings of its manifest and the inputs that
/// it lists, and has each compared with the dataset's files. Writes nothing; one scene is held at a
/// time.
/// @param listener  hears how far it is, and which software has another version than then
/// @param plugin_xml_files  where to look for writers; empty: all that installed packages export
/// @throws ErrorList: inputs that are missing or have changed, each with its name
void redraw(const output::WrittenDataset& dataset, output::SceneVerifier& verifier,
            output::VerificationListener& listener,
            const std::vector<std::string>& plugin_xml_files = {});

}  // namespace synthetic_dataset::run
