#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "output/output_options.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::config {

/// Reads `output_folder`, `if_exists`, `sync`, `shard` and `image`.
[[nodiscard]] output::StoreOptions readOutput(Parameters root);

/// Reads `processes`; 1 where there is a shard.
[[nodiscard]] int readProcesses(Parameters root, bool is_shard);

/// Reads `only_scenes: [17]`, or one number.
[[nodiscard]] std::set<std::int64_t> readOnlyScenes(Parameters root);

/// Reads `writers`, left out the original's three, and where each puts its files.
/// @param output_folder  of the run; empty when it has none
[[nodiscard]] std::vector<output::WriterOptions> readWriters(Parameters root,
                                                             const std::string& output_folder);

/// The deepest folder that all the writers' folders share, for the manifest.
[[nodiscard]] std::string commonFolder(const std::vector<output::WriterOptions>& writers);

}  // namespace synthetic_dataset::config
