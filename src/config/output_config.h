#pragma once

#include <string>
#include <vector>

#include "config/config.h"

namespace synthetic_dataset::config {

/// Reads `output_folder`, `if_exists` and `image`.
[[nodiscard]] OutputConfig readOutput(Parameters root);

/// Reads `writers`, left out the original's three, and where each puts its files.
/// @param output_folder  of the run; empty when it has none
[[nodiscard]] std::vector<WriterConfig> readWriters(Parameters root,
                                                    const std::string& output_folder);

/// The deepest folder that all the writers' folders share, for the manifest.
[[nodiscard]] std::string commonFolder(const std::vector<WriterConfig>& writers);

}  // namespace synthetic_dataset::config
