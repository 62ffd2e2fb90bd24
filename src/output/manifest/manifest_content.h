#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/sqlite.h"
#include "output/manifest/manifest_schema.h"
#include "output/manifest/run_description.h"
#include "output/store_types.h"

namespace synthetic_dataset::output {

/// What an earlier run's manifest says, read at once.
struct ManifestContent {
  bool complete = false;
  bool is_current = false;       ///< whether its tables are those of this software, with the truth
  std::int64_t scene_count = 0;  ///< that are there
  std::optional<Shard> shard;
  RunDescription run;
  std::vector<StoreWriter> writers;  ///< their folders are absolute; without user files
  std::vector<std::string> files;    ///< absolute
};

/// Whether the list of a dataset's files is read, which may be long.
enum class ManifestFiles { kRead, kLeftOut };

/// @param file  the absolute path of a manifest
/// @throws Error when it is no manifest of this version, or damaged; where files are left out, only
///     what is read is looked at
[[nodiscard]] ManifestContent readManifest(const std::string& file,
                                           ManifestFiles files = ManifestFiles::kRead);

/// The same of an open manifest of this version, without the list of files.
/// @param folder  the manifest's, absolute
[[nodiscard]] ManifestContent readWithoutFiles(const base::SqliteDatabase& database,
                                               const std::string& folder);

/// The manifests of shards in a folder, in alphabetical order.
[[nodiscard]] std::vector<std::string> shardManifests(const std::string& folder);

}  // namespace synthetic_dataset::output
