#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "output/output_options.h"

namespace synthetic_dataset::output {

/// "2/8"
[[nodiscard]] std::string shardText(const Shard& shard);

/// Whether an instant belongs to a shard. Blocks are long enough that work in a row stays together,
/// and short enough that all shards have as much to do.
[[nodiscard]] bool belongsTo(const Shard& shard, std::int64_t instant, std::int64_t instant_count);

/// The version of the manifest's tables; docs/manifest.md describes them.
constexpr const char* kManifestVersion = "7";

/// That of release 0.1.0, which is read as well. Objects that are not in the scene have a pose in
/// it: where they would be, or 100 km below the world. It lacks constraints, and the truth that
/// labels follow from.
constexpr const char* kVersionOfFirstRelease = "4";

/// @throws Error with the versions, where the software does not read this one
void requireKnownVersion(const std::string& version);

/// The tables of an empty manifest, as SQL, but for those of truth_tables.h. SQLite refuses rows
/// that break their constraints; a constraint's name says what is wrong with such a row.
extern const char* const kManifestTables;

/// Where a dataset's manifest lies, or that of a shard of it.
[[nodiscard]] std::string manifestFile(const std::string& folder,
                                       const std::optional<Shard>& shard = std::nullopt);

/// Where the program `report` leaves a page of a dataset. It is none of the dataset's files:
/// nothing that is done with them looks at it.
[[nodiscard]] std::string reportFile(const std::string& folder);

/// The shard that a file's name is that of a manifest of; nothing for any other name.
[[nodiscard]] std::optional<Shard> shardOfManifest(const std::string& file_name);

}  // namespace synthetic_dataset::output
