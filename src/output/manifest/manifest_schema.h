#pragma once

#include <optional>
#include <string>

#include "output/manifest/shard.h"

namespace synthetic_dataset::output {

/// The version of the manifest's tables; docs/manifest.md describes them.
constexpr const char* kManifestVersion = "4";

/// The tables of an empty manifest, as SQL.
extern const char* const kManifestTables;

/// Where a dataset's manifest lies, or that of a shard of it.
[[nodiscard]] std::string manifestFile(const std::string& folder,
                                       const std::optional<Shard>& shard = std::nullopt);

/// The shard that a file's name is that of a manifest of; nothing for any other name.
[[nodiscard]] std::optional<Shard> shardOfManifest(const std::string& file_name);

}  // namespace synthetic_dataset::output
