#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "output/output_options.h"

namespace synthetic_dataset::output {

/// "2/8"
[[nodiscard]] std::string shardText(const Shard& shard);

/// Whether an instant belongs to a shard. Blocks are long enough to keep successive instants
/// together, and short enough that all shards have about the same amount of work.
[[nodiscard]] bool belongsTo(const Shard& shard, std::int64_t instant, std::int64_t instant_count);

/// The version of the manifest's tables; docs/manifest.md describes them.
constexpr const char* kManifestVersion = "7";

/// The version of release 0.1.0, which can be read as well. In it, objects that are not in the
/// scene still have a pose: where they would be, or 100 km below the world. It lacks constraints,
/// and the truth from which labels follow.
constexpr const char* kVersionOfFirstRelease = "4";

/// @throws Error naming the versions, if the software cannot read this one
void requireKnownVersion(const std::string& version);

/// The tables of an empty manifest as SQL, except those of truth_tables.h. SQLite refuses rows that
/// violate their constraints; a constraint's name says what is wrong with such a row.
extern const char* const kManifestTables;

/// The path of the manifest of a dataset, or of one of its shards.
[[nodiscard]] std::string manifestFile(const std::string& folder,
                                       const std::optional<Shard>& shard = std::nullopt);

/// Where the program `report` puts its page about a dataset. The page is not one of the dataset's
/// files, and everything that works on those ignores it.
[[nodiscard]] std::string reportFile(const std::string& folder);

/// The shard whose manifest has this file name; nothing for any other name.
[[nodiscard]] std::optional<Shard> shardOfManifest(const std::string& file_name);

}  // namespace synthetic_dataset::output
